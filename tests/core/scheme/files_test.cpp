// Verdicts over solids in a folder `shared` beside the checkout (or SWEEPMESH_SHARED), where there
// is one.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>

#include "sweepmesh/base/errors.h"
#include "sweepmesh/scheme/assess.h"
#include "valid_scheme.h"

namespace sweepmesh {
namespace {

namespace fs = std::filesystem;

fs::path shared_folder() {
  if (const char* set = std::getenv("SWEEPMESH_SHARED")) return set;
  return fs::path(SWEEPMESH_SOURCE_DIR).parent_path() / "shared";
}

std::vector<fs::path> files_in(const std::string& name) {
  std::vector<fs::path> out;
  const fs::path folder = shared_folder() / name;
  if (!fs::is_directory(folder)) return out;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".step" || entry.path().extension() == ".stp")
      out.push_back(entry.path());
  std::ranges::sort(out);
  return out;
}

/// Assesses each solid of a file; what is sweepable has valid schemes, what is not has sentences,
/// and neither takes long.
bool is_sweepable(const fs::path& file) {
  SCOPED_TRACE(file.filename());
  bool all = true;
  const int n_solids = Model::from_file(file.string()).n_solids();
  for (int solid = 0; solid < n_solids; ++solid) {
    const Model model = Model::from_file(file.string(), solid);
    Context context;
    const auto start = std::chrono::steady_clock::now();
    const Assessment found = assess(model, {}, context);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    EXPECT_LT(taken.count(), 20.0);
    for (const Scheme& scheme : found.schemes) test::expect_valid_scheme(model, scheme);
    EXPECT_NE(found.is_sweepable(), !found.reasons.empty());
    for (const Reason& reason : found.reasons) EXPECT_TRUE(reason.text.ends_with("."));
    all &= found.is_sweepable();
    std::cout << file.filename() << " " << model.faces().size() << " faces, " << taken.count()
              << " s: " << (found.is_sweepable() ? "sweepable" : found.reasons.front().text)
              << "\n";
  }
  return all;
}

TEST(Files, GalleryHasTheVerdictsOfItsManifest) {
  const std::set<std::string> refused = {"sphere_two_voids", "sphere_three_voids",
                                         "genus3_cross_drilled", "curved_through_hole"};
  const auto files = files_in("gallery");
  if (files.empty()) GTEST_SKIP() << "no gallery beside the checkout";
  for (const fs::path& file : files)
    EXPECT_EQ(is_sweepable(file), !refused.contains(file.stem().string())) << file;
}

TEST(Files, PrismaticPartsOfTheCorpusAreSweptAndOthersRefused) {
  const auto files = files_in("corpus");
  if (files.empty()) GTEST_SKIP() << "no corpus beside the checkout";
  for (const fs::path& file : files) {
    const std::string name = file.stem().string();
    const bool sweepable = is_sweepable(file);
    const bool is_prismatic = name.starts_with("mfcad") || name == "mambo_m1" || name == "mambo_s8";
    EXPECT_TRUE(sweepable || !is_prismatic) << name;
    EXPECT_FALSE(sweepable && name.starts_with("nist")) << name;
  }
}

}  // namespace
}  // namespace sweepmesh
