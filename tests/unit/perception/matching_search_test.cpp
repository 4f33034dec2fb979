#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/perception/matching/hamming_search.hpp"
#include "tests/reference/every_target.hpp"
#include "tests/reference/hamming_reference.hpp"

namespace striate::perception {
namespace {

using reference::disturbed;
using reference::random_descriptors;

DescriptorStore store_of(const std::vector<Descriptor>& descriptors) {
  DescriptorStore store;
  store.append(descriptors);
  return store;
}

/// Queries near some of the stored ones, on both sides of every limit, and all alike at places.
std::vector<Descriptor> near(const std::vector<Descriptor>& stored, std::size_t count) {
  std::vector<Descriptor> queries = random_descriptors(count, 99);
  for (std::size_t q = 0; q < count && !stored.empty(); q += 2) {
    const unsigned seed = static_cast<unsigned>(q) * 977U;
    queries[q] = disturbed(stored[q * 31 % stored.size()], 40 + static_cast<int>(q % 16), seed);
  }
  return queries;
}

void expect_as_reference(const std::vector<Descriptor>& queries,
                         const std::vector<Descriptor>& stored, std::uint32_t limit) {
  const DescriptorStore store = store_of(stored);
  const auto expected_below = reference::matches_below(queries, stored, limit);
  const auto expected_nearest = reference::nearest_two(queries, stored, limit);
  reference::on_every_target([&](const std::string& name) {
    HammingSearch search;
    EXPECT_THAT(search.below(queries, store, limit), testing::ElementsAreArray(expected_below))
        << name << ", limit " << limit << ", " << stored.size() << " stored";
    EXPECT_THAT(search.nearest_two(queries, store, limit),
                testing::ElementsAreArray(expected_nearest))
        << name << ", limit " << limit << ", " << stored.size() << " stored";
  });
}

TEST(HammingSearch, GivesWhatTheScalarReferenceGivesOnEveryInstructionSet) {
  for (const std::size_t count : {1U, 7U, 8U, 9U, 15U, 16U, 17U, 511U, 512U, 513U, 1200U}) {
    const std::vector<Descriptor> stored = random_descriptors(count, count);
    for (const std::size_t query_count : {1U, 3U, 4U, 5U, 37U}) {
      expect_as_reference(near(stored, query_count), stored, 48);
    }
  }
}

TEST(HammingSearch, IsExactForEveryLimit) {
  const std::vector<Descriptor> stored = random_descriptors(700, 5);
  const std::vector<Descriptor> queries = near(stored, 21);
  for (const std::uint32_t limit : {0U, 1U, 41U, 48U, 64U, 65U, 100U, 128U, 129U, 256U, 257U}) {
    expect_as_reference(queries, stored, limit);
  }
}

TEST(HammingSearch, CountsEveryBitOnceAndTakesTheLimitAsExclusive) {
  const std::vector<Descriptor> stored = random_descriptors(1, 8);
  for (unsigned bit = 0; bit < 256; ++bit) {
    const std::vector<Descriptor> query = {disturbed(stored[0], 1, bit * 128)};
    HammingSearch search;
    const DescriptorStore store = store_of(stored);
    EXPECT_EQ(search.below(query, store, 2).size(), 1U) << bit;
    EXPECT_TRUE(search.below(query, store, 1).empty()) << bit;
  }
  // All bits in the same words, and spread: the quick bounds must not rule out either.
  for (unsigned seed = 0; seed < 400; ++seed) {
    const std::vector<Descriptor> query = {disturbed(stored[0], 47, seed),
                                           disturbed(stored[0], 48, seed)};
    HammingSearch search;
    const DescriptorStore store = store_of(stored);
    const auto matches = search.below(query, store, 48);
    ASSERT_EQ(matches.size(), 1U) << seed;
    EXPECT_EQ(matches[0], (Match{0, 0, 47}));
  }
}

TEST(HammingSearch, OfEquallyNearOnesTheLowestIndexComesFirst) {
  const Descriptor one = random_descriptors(1, 3)[0];
  const std::vector<Descriptor> stored(1100, disturbed(one, 20, 7));
  expect_as_reference({one, one, one}, stored, 257);
  expect_as_reference({one, one, one}, stored, 48);
  HammingSearch search;
  const DescriptorStore store = store_of(stored);
  const std::vector<Descriptor> query = {one};
  EXPECT_EQ(search.nearest_two(query, store)[0], (NearestTwo{0, 1, 20, 20}));
}

TEST(HammingSearch, FindsEverythingWhereAllAreOppositeOrAlike) {
  const Descriptor zeros, ones{{~0ULL, ~0ULL, ~0ULL, ~0ULL}};
  std::vector<Descriptor> stored(600, ones);
  stored[300] = zeros;
  expect_as_reference({zeros, ones, zeros, ones, zeros}, stored, 48);
  expect_as_reference({zeros, ones, zeros, ones, zeros}, stored, 257);
}

TEST(HammingSearch, NothingStoredOrNothingAskedGivesNothing) {
  HammingSearch search;
  const std::vector<Descriptor> some = random_descriptors(3, 1);
  EXPECT_TRUE(search.below(some, DescriptorStore(), 257).empty());
  EXPECT_THAT(search.nearest_two(some, DescriptorStore()), testing::Each(NearestTwo{}));
  EXPECT_TRUE(search.below({}, store_of(some), 257).empty());
  EXPECT_TRUE(search.nearest_two({}, store_of(some)).empty());
}

TEST(HammingSearch, DescriptorsBehindTheLastAreNotFound) {
  // The free places of the last blocks are zero: a query of zeros is near them.
  HammingSearch search;
  DescriptorStore store = store_of(random_descriptors(21, 1));
  const std::vector<Descriptor> zeros(1);
  for (const Match& match : search.below(zeros, store, 257)) EXPECT_LT(match.stored, 21U);
  EXPECT_EQ(search.below(zeros, store, 257).size(), 21U);
  store.clear();
  EXPECT_TRUE(search.below(zeros, store, 257).empty());
}

TEST(DescriptorStore, GivesBackWhatWasAppended) {
  const std::vector<Descriptor> some = random_descriptors(37, 2);
  const DescriptorStore store = store_of(some);
  ASSERT_EQ(store.size(), 37U);
  for (std::size_t k = 0; k < some.size(); ++k) EXPECT_EQ(store.at(k), some[k]);
  EXPECT_THROW((void)store.at(37), std::out_of_range);
}

TEST(DescriptorStore, HasRoomForWhatWasReserved) {
  DescriptorStore store;
  store.reserve(100);
  const std::vector<Descriptor> some = random_descriptors(100, 2);
  store.append(some[0]);
  const DescriptorBlock* before = store.blocks().data();
  for (std::size_t k = 1; k < some.size(); ++k) store.append(some[k]);
  EXPECT_EQ(store.blocks().data(), before);
}

}  // namespace
}  // namespace striate::perception
