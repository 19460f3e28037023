#include <insonate/cases/Phantom.h>
#include <insonate/segmentation/Guide.h>
#include <insonate/segmentation/Recipe.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

namespace insonate {
namespace {

/// A piece of a structure in an axial slice: its voxels, and their middle.
struct Piece {
  std::vector<std::size_t> offsets;
  Vec3 sum;
  std::size_t voxels() const { return offsets.size(); }
  Vec3 middle() const { return sum / double(voxels()); }
};

/// The pieces of a label in each slice on one side of the patient (-1: right), those next to the middle first.
std::vector<std::vector<Piece>> piecesOf(const LabelMap& labels, std::uint8_t label, int side) {
  const VolumeGeometry& g = labels.geometry;
  const Transform patientFromIndex = g.patientFromIndex();
  std::vector<std::vector<Piece>> slices(std::size_t(g.size[2]));
  for (int k = 0; k < g.size[2]; ++k) {
    const auto wanted = [&](int i, int j) {
      return g.contains(i, j, k) && labels.at(i, j, k) == label &&
             (patientFromIndex * Vec3{double(i), double(j), double(k)}).x * side > 0;
    };
    std::vector<bool> seen(std::size_t(g.size[0]) * g.size[1]);
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        std::vector<std::pair<int, int>> todo{{i, j}};
        Piece piece;
        while (!todo.empty()) {
          const auto [a, b] = todo.back();
          todo.pop_back();
          if (!wanted(a, b) || seen[std::size_t(b) * g.size[0] + a]) continue;
          seen[std::size_t(b) * g.size[0] + a] = true;
          piece.offsets.push_back(g.offset(a, b, k));
          piece.sum = piece.sum + patientFromIndex * Vec3{double(a), double(b), double(k)};
          for (const auto& [da, db] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) todo.emplace_back(a + da, b + db);
        }
        if (piece.voxels() > 20) slices[std::size_t(k)].push_back(piece);
      }
    std::ranges::sort(slices[std::size_t(k)], {}, [](const Piece& p) { return std::abs(p.middle().x); });
  }
  return slices;
}

/// Points along a line, each 1 mm beside it.
std::vector<Vec3> clicksOn(const std::vector<Vec3>& line, std::size_t count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(0, 6.28);
  std::vector<Vec3> clicks_mm;
  for (std::size_t n = 0; n < count; ++n) {
    const double a = angle(random);
    clicks_mm.push_back(line[2 + (line.size() - 5) * n / (count - 1)] + Vec3{std::cos(a), std::sin(a), 0});
  }
  return clicks_mm;
}

class GuideScores : public testing::TestWithParam<CtContrast> {
 protected:
  void SetUp() override {
    auto made = makePhantom("textbook", 1, {}, GetParam());
    ASSERT_TRUE(made) << made.error().message;
    patient_ = std::move(*made);
    truth_ = patient_.labels;
    guide_ = *readGuide(guidePresets().front().text);
    edit_ = std::make_unique<LabelEdit>(patient_.ct, patient_.labels);
    perform("automatic", {});
  }
  const GuideStep& step(const std::string& name) const {
    return *std::ranges::find(guide_.steps, name, &GuideStep::name);
  }
  void perform(const std::string& name, const std::vector<Vec3>& clicks_mm) {
    const auto way = methodFor(step(name), clicks_mm, patient_.ct);
    ASSERT_TRUE(way) << way.error().message;
    const auto done = insonate::perform(Recipe{name, way->steps}, *edit_);
    ASSERT_TRUE(done) << done.error().message;
    EXPECT_THAT(checkGuideStep(step(name), clicks_mm, patient_.labels), testing::IsEmpty()) << name;
  }
  /// Counts the voxels that `counts` accepts.
  template <class Counts>
  double dice(std::uint8_t label, const Counts& counts) const {
    const VolumeGeometry& g = truth_.geometry;
    const Transform patientFromIndex = g.patientFromIndex();
    std::size_t found = 0, there = 0, both = 0;
    for (int k = 0; k < g.size[2]; ++k)
      for (int j = 0; j < g.size[1]; ++j)
        for (int i = 0; i < g.size[0]; ++i) {
          const bool a = patient_.labels.at(i, j, k) == label, b = truth_.at(i, j, k) == label;
          if ((!a && !b) || !counts(patientFromIndex * Vec3{double(i), double(j), double(k)})) continue;
          found += a, there += b, both += a && b;
        }
    return 2.0 * double(both) / double(found + there);
  }
  /// A vessel on the patient's right from `low` to `high`, against what lies within 10 mm of its middle, without the
  /// thin branches there.
  double vessel(std::uint8_t label, const std::string& name, double low, double high) {
    std::vector<Vec3> line;
    std::set<std::size_t> own;
    for (const auto& pieces : piecesOf(truth_, label, -1)) {
      if (pieces.empty()) continue;
      const auto largest = std::ranges::max_element(pieces, {}, &Piece::voxels);
      const Vec3 middle = largest->middle();
      if (middle.z < low || middle.z > high) continue;
      line.push_back(middle);
      own.insert(largest->offsets.begin(), largest->offsets.end());
    }
    const auto clicks_mm = clicksOn(line, 4);
    perform(name, clicks_mm);
    const Transform indexFromPatient = truth_.geometry.indexFromPatient();
    return dice(label, [&](Vec3 p) {
      const auto [i, j, k] = nearestVoxel(indexFromPatient * p);
      if (truth_.at(i, j, k) == label && !own.contains(truth_.geometry.offset(i, j, k))) return false;
      const bool between = (p.z - clicks_mm.front().z) * (p.z - clicks_mm.back().z) < 0;
      return between && std::ranges::any_of(line, [&](Vec3 m) { return norm(p - m) < 10; });
    });
  }

  PatientCase patient_;
  LabelMap truth_;
  Guide guide_;
  std::unique_ptr<LabelEdit> edit_;
};
INSTANTIATE_TEST_SUITE_P(Contrast, GuideScores, testing::Values(CtContrast::kNative, CtContrast::kArterial),
                         [](const auto& test) { return test.param == CtContrast::kNative ? "native" : "arterial"; });

TEST_P(GuideScores, ANeckFromAFewClicksEach) {
  std::map<std::string, double> found;
  found["vein, 4 clicks"] = vessel(kVein, "vein-right", -44, 49);
  found["artery, 4 clicks"] = vessel(kArtery, "artery-right", -28, 24);

  std::vector<Vec3> thyroid;
  for (const int side : {-1, 1}) {
    std::vector<Vec3> lobe;
    for (const auto& pieces : piecesOf(truth_, kThyroid, side))
      if (!pieces.empty()) lobe.push_back(std::ranges::max_element(pieces, {}, &Piece::voxels)->middle());
    thyroid.push_back(lobe[lobe.size() / 4]);
    thyroid.push_back(lobe[lobe.size() * 3 / 4]);
  }
  perform("thyroid", thyroid);
  found["thyroid, 4 clicks"] = dice(kThyroid, [](Vec3) { return true; });

  std::vector<Vec3> sternal, clavicular;
  for (const auto& pieces : piecesOf(truth_, kSternocleidomastoid, -1)) {
    if (!pieces.empty()) sternal.push_back(pieces.front().middle());
    if (pieces.size() > 1) clavicular.push_back(pieces.back().middle());
  }
  perform("sternocleidomastoid-right", clicksOn(sternal, 4));
  perform("clavicular-right", clicksOn(clavicular, 3));
  found["sternocleidomastoid, 7 clicks"] = dice(kSternocleidomastoid, [](Vec3 p) { return p.x < 0; });

  for (const auto& [what, score] : found) {
    std::printf("%s: %.3f\n", what.c_str(), score);
    EXPECT_GT(score, what.starts_with("vein") ? 0.94 : what.starts_with("artery") ? 0.9 : 0.85) << what;
  }
}

}  // namespace
}  // namespace insonate
