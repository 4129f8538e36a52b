// SPDX-License-Identifier: MIT
#include <tests/oracle/samples.hpp>
#include <tests/raster/meshes.hpp>

#include <gtest/gtest.h>

namespace {

TEST(Partition, FansStripsAndVoronoiLikeMeshesDrawEachPixelOnce) {
  const tests::Cover cover = tests::cover_by_meshes(oracle::samples(150, 5000));
  EXPECT_EQ(cover.refused, 0);
  EXPECT_EQ(cover.twice, 0);
  EXPECT_EQ(cover.missing, 0);
  EXPECT_GT(cover.cells, cover.meshes * 20);
}

}  // namespace
