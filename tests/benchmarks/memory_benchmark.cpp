#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <opencv2/features2d.hpp>
#include <random>
#include <stdexcept>

#include "striate/memory/long_term/memory_file.hpp"
#include "striate/memory/long_term/memory_tables.hpp"
#include "striate/memory/long_term/view_codec.hpp"
#include "striate/perception/matching/hamming_search.hpp"

/// memory_benchmark [FOLDER] [LANDMARKS]: 10,000 landmarks with 5 views of 150 descriptors. Opens
/// the memory and reads every view, against reading the same bytes from a flat file; both cold (the
/// kernel is told to drop their pages), in turns, medians. Then 400 keypoints against all of it,
/// exactly, beside OpenCV's brute-force matcher.
namespace striate {
namespace {

constexpr int kViews = 5;
constexpr int kDescriptors = 150;
constexpr int kTurns = 9;
constexpr int kQueries = 400;
constexpr std::uint32_t kLimit_bits = 48;

double seconds_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

memory::StoredView random_view(std::mt19937_64& random) {
  memory::StoredView view;
  view.width_px = 200.0;
  view.height_px = 150.0;
  view.descriptors.resize(kDescriptors);
  view.keypoints.resize(kDescriptors);
  for (memory::StoredDescriptor& one : view.descriptors) {
    for (std::size_t at = 0; at < one.size(); at += 8) {
      const std::uint64_t word = random();
      std::memcpy(one.data() + at, &word, 8);
    }
  }
  for (perception::ViewKeypoint& one : view.keypoints)
    one.x_px = static_cast<float>(random() % 200);
  return view;
}

void write_both(const std::string& memory, const std::string& flat, int landmarks) {
  std::ofstream stream(flat, std::ios::binary);
  memory::MemoryOptions options;
  options.access = memory::Access::session;
  memory::MemoryFile file(memory, options);
  memory::MemoryTables tables(file.database());
  file.database().exec("BEGIN");
  const memory::Session session =
      tables.sessions.begin(memory::SessionKind::import, "benchmark", "", 0);
  std::mt19937_64 random(1);
  for (int k = 0; k < landmarks; ++k) {
    memory::Landmark landmark;
    landmark.session = session.id;
    landmark.name = fmt::format("thing {}", k);
    const std::int64_t id = tables.landmarks.add(landmark);
    for (int v = 0; v < kViews; ++v) {
      memory::StoredView view = random_view(random);
      view.landmark = id;
      view.session = session.id;
      tables.views.add(view);
      for (const auto bytes :
           {memory::bytes_of(view.descriptors), memory::bytes_of(view.keypoints)}) {
        stream.write(reinterpret_cast<const char*>(bytes.data()),
                     static_cast<std::streamsize>(bytes.size()));
      }
    }
  }
  tables.sessions.end(session.id, 0.0, "kept");
  file.database().exec("COMMIT");
}

/// The kernel forgets what it has of a file, so that the next reading comes from the disk.
void cool(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY);
  fdatasync(descriptor);
  posix_fadvise(descriptor, 0, 0, POSIX_FADV_DONTNEED);
  close(descriptor);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Checked, and side by side in one buffer as the flat file is.
void read_memory(const std::string& memory, std::vector<char>& bytes) {
  memory::MemoryFile file(memory, {});
  memory::MemoryTables tables(file.database());
  char* at = bytes.data();
  tables.views.for_each([&](const memory::StoredView& view) {
    if (view.damaged) std::abort();
    for (const auto part : {memory::bytes_of(view.descriptors), memory::bytes_of(view.keypoints)}) {
      std::memcpy(at, part.data(), part.size());
      at += part.size();
    }
  });
}

void load(const std::vector<char>& bytes, perception::DescriptorStore& store) {
  constexpr std::size_t kView_bytes = kDescriptors * 48;
  for (std::size_t at = 0; at + kView_bytes <= bytes.size(); at += kView_bytes) {
    for (std::size_t k = 0; k < kDescriptors; ++k) {
      memory::StoredDescriptor one{};
      std::memcpy(one.data(), bytes.data() + at + 32 * k, 32);
      store.append(memory::descriptor_of(one));
    }
  }
}

/// @return a sum, so that nothing can be left out.
std::uint64_t read_flat(const std::string& flat, std::vector<char>& bytes) {
  const int descriptor = open(flat.c_str(), O_RDONLY);
  std::size_t at = 0;
  while (at < bytes.size()) {
    const ssize_t size = read(descriptor, bytes.data() + at, bytes.size() - at);
    if (size <= 0) break;
    at += static_cast<std::size_t>(size);
  }
  close(descriptor);
  return at;
}

void compare_opening(const std::string& memory, const std::string& flat,
                     perception::DescriptorStore& store) {
  std::vector<char> bytes(std::filesystem::file_size(flat));
  std::vector<char> from_memory(bytes.size());
  std::vector<double> memory_s;
  std::vector<double> flat_s;
  for (int turn = 0; turn < kTurns; ++turn) {
    cool(flat);
    flat_s.push_back(seconds_of([&] { (void)read_flat(flat, bytes); }));
    cool(memory);
    memory_s.push_back(seconds_of([&] { read_memory(memory, from_memory); }));
  }
  if (bytes != from_memory) throw std::runtime_error("the memory holds other bytes");
  load(bytes, store);
  const double mb = static_cast<double>(bytes.size()) / 1e6;
  fmt::print("{:.0f} MB of views; as a memory {:.1f} % larger\n", mb,
             100.0 * (static_cast<double>(std::filesystem::file_size(memory)) /
                          static_cast<double>(bytes.size()) -
                      1.0));
  fmt::print("flat file, read cold           {:7.3f} s   {:6.0f} MB/s\n", median(flat_s),
             mb / median(flat_s));
  fmt::print("memory, opened and read cold   {:7.3f} s   {:6.0f} MB/s   {:.2f} of the flat file\n",
             median(memory_s), mb / median(memory_s), median(flat_s) / median(memory_s));
}

/// All of it with our search; a tenth of it with both, because OpenCV takes minutes for all.
void compare_recognition(const perception::DescriptorStore& store) {
  std::vector<perception::Descriptor> queries;
  for (int q = 0; q < kQueries; ++q) {
    perception::Descriptor twin = store.at(static_cast<std::size_t>(q) * 997 % (store.size() / 10));
    twin.words[0] ^= 0x3FFFFFFF;
    queries.push_back(twin);
  }
  perception::HammingSearch search;
  std::size_t found = 0;
  const double all_s =
      seconds_of([&] { found = search.below(queries, store, kLimit_bits).size(); });
  fmt::print("{} keypoints against {} descriptors, below {} bits, exact, one core: {:.3f} s\n",
             kQueries, store.size(), kLimit_bits, all_s);
  std::vector<perception::Descriptor> tenth;
  for (std::size_t k = 0; k < store.size() / 10; ++k) tenth.push_back(store.at(k));
  perception::DescriptorStore small;
  small.append(tenth);
  const double ours_s =
      seconds_of([&] { found = search.below(queries, small, kLimit_bits).size(); });
  const cv::Mat query_rows(kQueries, 32, CV_8U, queries.data());
  cv::setNumThreads(1);
  double theirs_s = 0.0;
  std::size_t theirs = 0;
  constexpr std::size_t kPart = 250'000;  // OpenCV takes no more rows at once
  for (std::size_t begin = 0; begin < tenth.size(); begin += kPart) {
    const std::size_t count = std::min(kPart, tenth.size() - begin);
    const cv::Mat rows(static_cast<int>(count), 32, CV_8U, tenth.data() + begin);
    std::vector<std::vector<cv::DMatch>> matches;
    theirs_s += seconds_of([&] {
      cv::BFMatcher(cv::NORM_HAMMING).radiusMatch(query_rows, rows, matches, kLimit_bits - 1);
    });
    for (const auto& of_query : matches) theirs += of_query.size();
  }
  fmt::print(
      "against a tenth: Striate {:.3f} s ({} found), OpenCV's brute force {:.3f} s ({} "
      "found): {:.0f} times\n",
      ours_s, found, theirs_s, theirs, theirs_s / ours_s);
}

int run(const std::filesystem::path& folder, int landmarks) {
  std::filesystem::create_directories(folder);
  const std::string memory = folder / "memory_benchmark.db";
  const std::string flat = folder / "memory_benchmark.bin";
  std::filesystem::remove(memory);
  write_both(memory, flat, landmarks);
  perception::DescriptorStore store;
  store.reserve(static_cast<std::size_t>(landmarks) * kViews * kDescriptors);
  compare_opening(memory, flat, store);
  compare_recognition(store);
  for (const std::string& file : {memory, flat}) std::filesystem::remove(file);
  return 0;
}

}  // namespace
}  // namespace striate

int main(int argc, char** argv) {
  return striate::run(argc > 1 ? argv[1] : "out/memory_benchmark",
                      argc > 2 ? std::atoi(argv[2]) : 10000);
}
