#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "striate/platform/simulator/render/packet_kernels.hpp"
#include "striate/platform/simulator/render/patches.hpp"
#include "striate/platform/simulator/render/read_out_kernel.hpp"
#include "tests/reference/every_target.hpp"

namespace striate::simulator::render {
namespace {

/// Embree's u and v of sixteen rays on one quadrilateral, both halves of it.
struct Hits {
  std::array<float, kPacket> u, v;
};

class Numbers {
 public:
  float between(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }
  Hits hits() {
    Hits made;
    for (std::size_t i = 0; i < kPacket; ++i) {
      made.u[i] = between(0.0F, 1.0F);
      made.v[i] = between(0.0F, 1.0F);
    }
    return made;
  }
  std::vector<V4> colours(std::size_t count) {
    std::vector<V4> made(count);
    for (V4& c : made) {
      for (int k = 0; k < 4; ++k) c[k] = between(0.0F, 2.0F);
    }
    return made;
  }

 private:
  std::mt19937 random_{5};
};

bool same_bits(const void* a, const void* b, std::size_t bytes) {
  return std::memcmp(a, b, bytes) == 0;
}

cv::Mat3b noise_image(int width, int height) {
  cv::Mat3b image(height, width);
  std::mt19937 random(3);
  for (cv::Vec3b& pixel : image) {
    for (int c = 0; c < 3; ++c) pixel[c] = static_cast<std::uint8_t>(random());
  }
  return image;
}

TEST(PacketKernels, SampleATextureAsItIsSampledOneByOne) {
  const Texture texture(noise_image(256, 64));
  Numbers numbers;
  reference::on_every_target([&](const std::string& target) {
    for (int trial = 0; trial < 200; ++trial) {
      PacketTexture surface{&texture, {&texture.level(0.3F), &texture.level(2.0F)}, {}, {}};
      for (float& s : surface.s) s = numbers.between(-20.0F, 20.0F);
      for (float& t : surface.t) t = numbers.between(-20.0F, 20.0F);
      const Hits hit = numbers.hits();
      std::array<V4, kPacket> got, wanted;
      sample_packet(surface, hit.u.data(), hit.v.data(), got.data());
      for (std::size_t i = 0; i < kPacket; ++i) {
        wanted[i] = texture.sample(*surface.level[(i ^ (i >> 2U)) & 1U],
                                   Patch::at(surface.s, hit.u[i], hit.v[i]),
                                   Patch::at(surface.t, hit.u[i], hit.v[i]));
      }
      ASSERT_TRUE(same_bits(got.data(), wanted.data(), sizeof got)) << target;
    }
  });
}

TEST(PacketKernels, ReadTheBakedLightAsItIsReadOneByOne) {
  Numbers numbers;
  const std::vector<V4> texels = numbers.colours(7 * 5);
  const PacketLight map{texels.data(), 7, 5};
  reference::on_every_target([&](const std::string& target) {
    for (int trial = 0; trial < 200; ++trial) {
      Hits hit = numbers.hits();
      hit.u[3] = 1.0F;  // on the border, where the last cell is still meant
      hit.v[3] = 1.0F;
      std::array<V4, kPacket> got, wanted;
      light_packet(map, hit.u.data(), hit.v.data(), got.data());
      for (std::size_t i = 0; i < kPacket; ++i) {
        wanted[i] = baked_light_at(map, hit.u[i], hit.v[i]);
      }
      ASSERT_TRUE(same_bits(got.data(), wanted.data(), sizeof got)) << target;
    }
  });
}

TEST(PacketKernels, WeighTheMirrorImageAsOneByOne) {
  Numbers numbers;
  reference::on_every_target([&](const std::string& target) {
    for (int trial = 0; trial < 200; ++trial) {
      std::array<float, kPacket> x, y, z, got, wanted;
      const Vec3 normal = unit({numbers.between(-1, 1), numbers.between(-1, 1), 1.0F});
      for (std::size_t i = 0; i < kPacket; ++i) {
        const Vec3 d{numbers.between(-1, 1), numbers.between(-1, 1), numbers.between(-1, 1)};
        x[i] = d.x;
        y[i] = d.y;
        z[i] = d.z;
        wanted[i] = mirrored(0.8F, std::abs(dot(d, normal)) / length(d));
      }
      mirror_packet(0.8F, normal, x.data(), y.data(), z.data(), got.data());
      ASSERT_TRUE(same_bits(got.data(), wanted.data(), sizeof got)) << target;
    }
  });
}

TEST(PacketKernels, AimATileAsTheViewDoes) {
  SceneState state;
  state.robot = {3.0, 0.2, 0.4};
  state.head.pan_rad = 0.3;
  View view = view_of(state, CameraSettings{}, Eye::left, 320);
  view.skew_px = 0.1F;
  view.skew_by_u = 0.002F;
  view.skew_by_v = -0.003F;
  reference::on_every_target([&](const std::string& target) {
    for (const int left : {0, 152, 316}) {
      std::array<float, kPacket> x, y, z;
      aim_packet(view, left, 96, x.data(), y.data(), z.data());
      for (int i = 0; i < kPacket; ++i) {
        const Vec3 ray = view.ray(static_cast<float>(left + i % 4), static_cast<float>(96 + i / 4));
        const auto k = static_cast<std::size_t>(i);
        ASSERT_EQ(x[k], ray.x) << target;
        ASSERT_EQ(y[k], ray.y) << target;
        ASSERT_EQ(z[k], ray.z) << target;
      }
    }
  });
}

TEST(ReadOutKernel, ReadsARowAsPixelByPixel) {
  constexpr int kWidth = 37;  // no multiple of any vector
  Numbers numbers;
  const GaussTable gauss;
  const std::vector<V4> light = numbers.colours(kWidth);
  std::array<float, kWidth> sensitivity;
  for (float& s : sensitivity) s = numbers.between(0.7F, 1.05F);
  ReadOutRow row;
  row.noise_key = 0xFEDCBA98U;
  row.colour = {2, 1};
  row.filter = {0.72F, 1.0F};
  row.electrons = 9000.0F;
  row.full_well_e = 13000.0F;
  row.read_variance_e2 = 81.0F;
  row.gain = 1.7F;
  reference::on_every_target([&](const std::string& target) {
    std::array<float, kWidth> got;
    read_out_row(row, gauss, light.data(), sensitivity.data(), kWidth, got.data());
    for (int x = 0; x < kWidth; ++x) {
      ASSERT_EQ(got[static_cast<std::size_t>(x)],
                read_out_pixel(row, gauss, light.data(), sensitivity.data(), x))
          << target << ", column " << x;
    }
  });
}

}  // namespace
}  // namespace striate::simulator::render
