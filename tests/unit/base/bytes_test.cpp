#include "striate/base/bytes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace striate {
namespace {

TEST(Bytes, NumbersAreLittleEndian) {
  ByteWriter writer;
  writer.u16(0x1234);
  writer.i32(-2);
  EXPECT_EQ(writer.bytes(), (Bytes{0x34, 0x12, 0xFE, 0xFF, 0xFF, 0xFF}));
}

TEST(Bytes, ComeBackAsTheyWereWritten) {
  Bytes bytes{7};
  ByteWriter writer(bytes);
  writer.put(std::uint64_t{1} << 63);
  writer.put(-0.0);
  writer.put_text("gr\xC3\xBCn");
  writer.put_c_string("p3dx");
  writer.i8(-128);
  writer.i16(-32768);
  ByteReader reader(bytes);
  EXPECT_EQ(reader.u8(), 7) << "what was there before stays";
  EXPECT_EQ(reader.take<std::uint64_t>(), std::uint64_t{1} << 63);
  EXPECT_TRUE(std::signbit(reader.take<double>()));
  EXPECT_EQ(reader.take_text(), "gr\xC3\xBCn");
  EXPECT_EQ(reader.take_c_string(), "p3dx");
  EXPECT_EQ(reader.i8(), -128);
  EXPECT_EQ(reader.i16(), -32768);
  EXPECT_NO_THROW(reader.expect_end());
  EXPECT_FALSE(reader.ran_out());
}

TEST(Bytes, ReadingBeyondTheEndThrowsAndTakesNothing) {
  const Bytes bytes{1, 2, 3};
  ByteReader reader(bytes);
  EXPECT_THROW((void)reader.u32(), BadBytes);
  EXPECT_EQ(reader.left(), 3U);
  EXPECT_THROW(reader.expect_end(), BadBytes);
  EXPECT_THROW((void)reader.take_c_string(), BadBytes);
}

TEST(Bytes, OnRequestTheEndReadsAsZeroAndIsTold) {
  const Bytes bytes{1, 2, 3};
  ByteReader reader(bytes, ByteReader::Beyond::zero);
  EXPECT_EQ(reader.u16(), 0x0201);
  EXPECT_FALSE(reader.ran_out());
  EXPECT_EQ(reader.u16(), 0) << "half a number is none";
  EXPECT_TRUE(reader.ran_out());
  EXPECT_EQ(reader.u8(), 0) << "nothing is left of it";
}

TEST(Bytes, ATextWithoutItsNulIsAllThatIsLeft) {
  const Bytes bytes{'a', 'b'};
  ByteReader reader(bytes, ByteReader::Beyond::zero);
  EXPECT_EQ(reader.take_c_string(), "ab");
  EXPECT_TRUE(reader.ran_out());
}

TEST(Bytes, ACountMayNotPromiseMoreThanThereIs) {
  Bytes bytes;
  ByteWriter(bytes).u32(3);
  bytes.resize(bytes.size() + 23);
  EXPECT_THROW((void)ByteReader(bytes).take_count(8), BadBytes);
  bytes.push_back(0);
  EXPECT_EQ(ByteReader(bytes).take_count(8), 3U);
}

}  // namespace
}  // namespace striate
