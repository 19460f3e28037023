#include "ToolGrids.h"

#include <insonate/core/Hash.h>
#include <insonate/segmentation/Recipe.h>
#include <insonate/segmentation/Score.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <numbers>

namespace insonate {
namespace {

using testing::HasSubstr;

/// Every tool once, with something to do in the scene below.
constexpr const char* kAllTools = R"({
  "description": "all tools",
  "steps": [
    {"tool": "threshold", "label": "bone", "range_HU": [400, 3000]},
    {"tool": "opening", "label": "bone", "radius_mm": 0.9, "rest": "muscle"},
    {"tool": "largest_islands", "label": "bone", "islands": 1},
    {"tool": "connected", "label": "vein", "points_mm": [[-8, 0, 0]], "range_HU": [150, 350], "locked": ["bone"]},
    {"tool": "closing", "label": "vein", "radius_mm": 1.5},
    {"tool": "median", "label": "vein", "radius_mm": 1.1},
    {"tool": "gaussian", "label": "vein", "sigma_mm": 0.8},
    {"tool": "remove_small_islands", "label": "vein", "least_mm3": 20},
    {"tool": "island", "label": "vein", "points_mm": [[-8, 0, 0]]},
    {"tool": "vessel", "label": "artery", "points_mm": [[-8, 0, -14], [-8, 0, 14]], "largest_mm": 8, "over": ["vein", "soft tissue"]},
    {"tool": "tube", "label": "nerve", "points_mm": [[-8, 0, -14], [-8, 0, 14]], "largest_mm": 6, "darker_HU": 40, "brighter_HU": 30, "stiffness": 1, "over": ["vein", "soft tissue"]},
    {"tool": "logical", "label": "vein", "operation": "subtract", "with": "artery", "reach_mm": 1},
    {"tool": "paint", "label": "thyroid", "points_mm": [[0, 12, -4], [0, 12, 4]], "radius_mm": 3},
    {"tool": "paint", "label": "fat", "points_mm": [[0, 12, 0]], "radius_mm": 4, "slice_axis": 2, "only_HU": [-200, 90], "comment": "why"},
    {"tool": "margin", "label": "thyroid", "margin_mm": 1.5, "locked": ["vein", "artery"]},
    {"tool": "margin", "label": "thyroid", "margin_mm": -1},
    {"tool": "hollow", "label": "thyroid", "thickness_mm": 2, "wall": "outside"},
    {"tool": "draw", "label": "muscle", "points_mm": @LOW},
    {"tool": "draw", "label": "muscle", "points_mm": @HIGH},
    {"tool": "fill_between_slices", "label": "muscle"},
    {"tool": "scissors", "label": "soft tissue", "points_mm": [[-2, -30, 0], [2, -30, 0], [0, 0, 0]], "along": [0, 0, 1], "over": ["muscle"]},
    {"tool": "split_islands", "label": "muscle", "into": ["muscle", "sternocleidomastoid"]},
    {"tool": "smooth_together", "sigma_mm": 0.7, "labels": ["soft tissue", "muscle", "sternocleidomastoid"]},
    {"tool": "fast_marching", "label": "salivary gland", "points_mm": [[10, 10, 10]], "reach_mm": 5, "edge_HUpmm": 30},
    {"tool": "level_set", "label": "salivary gland", "rounds": 10},
    {"tool": "confidence_connected", "label": "cartilage", "points_mm": [[8, 0, 0]], "deviations": 2, "rounds": 2, "locked": ["bone"]},
    {"tool": "grow_from_seeds", "seeds": ["artery", "muscle"], "into": ["soft tissue"]},
    {"tool": "watershed", "seeds": ["bone", "muscle"], "into": ["soft tissue"], "box_mm": @BOX},
    {"tool": "outline", "label": "bone", "line_mm": [[8, 0, -6], [8, 0, -3], [8, 0, 0], [8, 0, 3], [8, 0, 6]], "section": 2, "points_mm": @RING, "reach_mm": 5},
    {"tool": "cut_off", "label": "salivary gland", "points_mm": [[10.2, -5, 10], [10.2, 25, 10]], "along": [0, 0, 1]}
  ]})";

std::string listed(const std::vector<Vec3>& points) {
  std::string text;
  for (const Vec3& p : points)
    text += (text.empty() ? "[" : ", [") + std::to_string(p.x) + ", " + std::to_string(p.y) + ", " +
            std::to_string(p.z) + "]";
  return "[" + text + "]";
}

/// The recipe with what lies on slices put on those of the grid.
std::string allTools(const VolumeGeometry& g) {
  const auto at = [&](double x, double y, double z) {
    return g.direction.column[0] * x + g.direction.column[1] * y + g.direction.column[2] * z;
  };
  std::string text = kAllTools;
  const auto put = [&](std::string_view name, const std::vector<Vec3>& points) {
    text.replace(text.find(name), name.size(), listed(points));
  };
  put("@LOW", {at(-15, -15, -10), at(15, -15, -10), at(0, 2, -10)});
  put("@HIGH", {at(-15, -15, 10), at(15, -15, 10), at(0, 2, 10)});
  std::vector<Vec3> ring;
  for (int ray = 0; ray < VesselOutline::kRays; ++ray) {
    const double angle = 2 * std::numbers::pi * ray / VesselOutline::kRays;
    ring.push_back({8 + 4 * std::cos(angle), 4 * std::sin(angle), 0});
  }
  put("@RING", ring);
  put("@BOX", {at(-17, -17, -17), at(17, 17, 17)});
  return text;
}

struct Scene {
  explicit Scene(const VolumeGeometry& g) : ct(g), labels(g, kSoftTissue) {
    const Transform patientFromIndex = g.patientFromIndex();
    for (int k = 0; k < g.size[2]; ++k)
      for (int j = 0; j < g.size[1]; ++j)
        for (int i = 0; i < g.size[0]; ++i) {
          const Vec3 p = patientFromIndex * Vec3{double(i), double(j), double(k)};
          const int hu = std::hypot(p.x + 8, p.y) < 5 ? 250 : std::hypot(p.x - 8, p.y) < 6 ? 700 : 50;
          ct.at(i, j, k) = static_cast<std::int16_t>(hu + int(hashNode(i, j, k, 9) % 21) - 10);
        }
  }
  CtVolume ct;
  LabelMap labels;
};

class RecipesOnGrids : public test::OnGrids {};
INSONATE_ON_GRIDS(RecipesOnGrids);

TEST_P(RecipesOnGrids, EveryToolReplaysToTheSameVoxelsOnAnyNumberOfThreads) {
  const auto recipe = readRecipe(allTools(grid()));
  ASSERT_TRUE(recipe) << recipe.error().message;
  Scene first(grid());
  LabelEdit edit(first.ct, first.labels);
  const auto changes = perform(*recipe, edit);
  ASSERT_TRUE(changes) << changes.error().message;
  ASSERT_EQ(changes->size(), recipe->steps.size());

  // Writing and reading again gives the same recipe.
  const auto again = readRecipe(textOf(*recipe));
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(textOf(*again), textOf(*recipe));
  Scene second(grid());
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  LabelEdit replay(second.ct, second.labels);
  ASSERT_TRUE(perform(*again, replay));
  EXPECT_EQ(second.labels.voxels, first.labels.voxels);

  while (edit.undoName()) edit.undo();
  EXPECT_EQ(first.labels.voxels, Scene(grid()).labels.voxels) << "all of it can be undone";
}

TEST_P(RecipesOnGrids, APreviewChangesNothingAndSaysWhatWillBeWritten) {
  Scene scene(grid());
  const auto recipe = readRecipe(R"({"steps": [{"tool": "threshold", "label": "bone", "range_HU": [400, 3000]}]})");
  ASSERT_TRUE(recipe);
  const auto preview = propose(recipe->steps[0], scene.ct, scene.labels);
  ASSERT_TRUE(preview);
  EXPECT_EQ(scene.labels.voxels, Scene(grid()).labels.voxels);
  LabelEdit edit(scene.ct, scene.labels);
  const auto change = perform(recipe->steps[0], edit);
  ASSERT_TRUE(change);
  EXPECT_EQ(std::size_t(std::ranges::count(preview->labels.voxels, std::uint8_t(kBone))), change->voxels);
}

/// A vein in muscle, with a voxel of fat in it, and beside an artery.
struct VeinInMuscle {
  VeinInMuscle() : ct(test::toolGrids()[0].geometry, 50), labels(ct.geometry, kMuscle) {
    for (int k = 3; k < 6; ++k)
      for (int j = 3; j < 6; ++j)
        for (int i = 3; i < 6; ++i) {
          labels.at(i, j, k) = kVein;
          labels.at(i + 3, j, k) = kArtery;
        }
    ct.at(4, 4, 4) = -100;
  }
  CtVolume ct;
  LabelMap labels;
};

LabelStep erasingVein(const VolumeGeometry& g) {
  LabelStep step;
  step.tool = step::Paint{{g.patientFromIndex() * Vec3{4, 4, 4}}, 8};
  step.label = step.rest = LabelStep::kSurroundings;
  step.over = std::vector<std::uint8_t>{kVein};
  return step;
}

TEST(Recipe, ErasedVoxelsGetTheLabelOfTheirSurroundings) {
  VeinInMuscle scene;
  LabelEdit edit(scene.ct, scene.labels);
  const auto change = perform(erasingVein(scene.ct.geometry), edit);
  ASSERT_TRUE(change) << change.error().message;
  EXPECT_EQ(change->voxels, 27U);
  EXPECT_EQ(scene.labels.at(3, 3, 3), kMuscle);
  EXPECT_EQ(scene.labels.at(5, 4, 4), kMuscle) << "the artery beside it does not grow into it";
  EXPECT_EQ(scene.labels.at(4, 4, 4), kFat) << "fat is fat";
  EXPECT_EQ(scene.labels.at(6, 4, 4), kArtery);
}

TEST(Recipe, EachRemovedPartHasItsOwnSurroundings) {
  VeinInMuscle scene;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) scene.labels.at(i, j, 0) = kFat, scene.ct.at(i, j, 0) = -100;
  scene.labels.at(1, 1, 0) = kVein;
  scene.labels.at(10, 10, 10) = kVein;
  scene.ct.at(9, 9, 9) = -900;
  scene.labels.at(9, 9, 9) = kVein;
  LabelStep step;
  step.tool = step::KeepLargest{1};
  step.label = kVein, step.rest = LabelStep::kSurroundings;
  LabelEdit edit(scene.ct, scene.labels);
  ASSERT_TRUE(perform(step, edit));
  EXPECT_EQ(scene.labels.at(1, 1, 0), kFat);
  EXPECT_EQ(scene.labels.at(10, 10, 10), kMuscle);
  EXPECT_EQ(scene.labels.at(9, 9, 9), kSoftTissue) << "no neighbor agrees with the CT value of air";
  EXPECT_EQ(scene.labels.at(4, 4, 4), kVein);
}

TEST(Recipe, PaintingSoftTissueLeavesSoftTissueAsItIs) {
  VeinInMuscle scene;
  scene.labels.at(4, 4, 4) = kSoftTissue;
  LabelStep step = erasingVein(scene.ct.geometry);
  step.label = kSoftTissue;
  step.over.reset();
  LabelEdit edit(scene.ct, scene.labels);
  ASSERT_TRUE(perform(step, edit));
  EXPECT_EQ(scene.labels.at(4, 4, 4), kSoftTissue);
  EXPECT_EQ(scene.labels.at(3, 3, 3), kSoftTissue);
}

TEST(Recipe, SurroundingsAreAWordInTheFile) {
  const Recipe recipe{{}, {erasingVein(test::toolGrids()[0].geometry)}, {}};
  EXPECT_THAT(textOf(recipe), HasSubstr("\"rest\": \"surroundings\""));
  const auto again = readRecipe(textOf(recipe));
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->steps[0].rest, LabelStep::kSurroundings);
  EXPECT_EQ(again->steps[0].label, LabelStep::kSurroundings);
}

TEST(Recipe, APreviewOfWhatIsErasedShowsNothingElse) {
  const CtVolume ct(test::toolGrids()[0].geometry);
  LabelMap labels(ct.geometry, kSoftTissue);
  labels.at(3, 3, 3) = labels.at(4, 3, 3) = kVein;
  labels.at(5, 3, 3) = kBone;
  LabelStep step;
  step.tool = step::Paint{{ct.geometry.patientFromIndex() * Vec3{3, 3, 3}}, 8};
  step.label = step.rest;
  step.over = std::vector<std::uint8_t>{kVein};
  Proposal shown;
  ASSERT_TRUE(preview(step, ct, labels, shown));
  EXPECT_EQ(std::ranges::count(shown.labels.voxels, kSoftTissue), 2) << "of what is soft tissue already, nothing";
}

TEST(Recipe, OnlyLabelsThatAreNamedAreOverwritten) {
  Scene scene(test::toolGrids()[0].geometry);
  scene.labels.at(20, 20, 20) = kVein;
  const auto recipe = readRecipe(
      R"({"steps": [{"tool": "paint", "label": "bone", "points_mm": [[0, 0, 0]], "radius_mm": 3, "over": ["vein"]}]})");
  ASSERT_TRUE(recipe) << recipe.error().message;
  LabelEdit edit(scene.ct, scene.labels);
  edit.rules.locked.set(kVein);
  EXPECT_EQ(perform(*recipe, edit)->front().voxels, 1u);
  EXPECT_TRUE(edit.rules.locked.test(kVein)) << "the edit's own rules are back";
}

/// Bone in the left half, vein in the right, on a row of voxels of 1 mm.
TEST(Recipe, LabelsThatNeverOverlapAreCombinedWithinAReach) {
  const VolumeGeometry g{{12, 1, 1}, {1, 1, 1}, {0, 0, 0}, {}};
  const auto after = [&](LogicalOperation operation, double reach_mm) {
    LabelMap labels(g, kVein);
    for (int i = 0; i < 6; ++i) labels.at(i, 0, 0) = kBone;
    const CtVolume ct(g, 0);
    LabelEdit edit(ct, labels);
    LabelStep step;
    step.label = kVein;
    step.tool = step::Logical{operation, kBone, reach_mm};
    const auto done = perform(step, edit);
    EXPECT_EQ(bool(done), reach_mm > 0) << (done ? "" : done.error().message);
    return std::pair(labels, done ? std::string() : done.error().message);
  };
  for (int i = 0; i < 12; ++i) {
    const bool bone = i < 6, near = !bone && i < 8;
    EXPECT_EQ(after(LogicalOperation::kSubtract, 2).first.at(i, 0, 0), bone ? kBone : near ? kSoftTissue : kVein) << i;
    EXPECT_EQ(after(LogicalOperation::kIntersect, 2).first.at(i, 0, 0), bone ? kBone : near ? kVein : kSoftTissue) << i;
    EXPECT_EQ(after(LogicalOperation::kAdd, 2).first.at(i, 0, 0), kVein) << i;
  }
  for (const auto operation : {LogicalOperation::kSubtract, LogicalOperation::kIntersect}) {
    const auto [labels, why] = after(operation, 0);
    EXPECT_THAT(why, HasSubstr("No voxel has two labels"));
    EXPECT_EQ(labels.at(11, 0, 0), kVein) << "a label does not vanish";
  }
}

TEST(Recipe, ALabelIsClearedByTakingItFromItself) {
  Scene scene(test::toolGrids()[0].geometry);
  scene.labels.at(20, 20, 20) = kVein;
  LabelEdit edit(scene.ct, scene.labels);
  LabelStep step;
  step.label = kVein;
  step.tool = step::Logical{LogicalOperation::kSubtract, kVein};
  const auto change = perform(step, edit);
  ASSERT_TRUE(change) << change.error().message;
  EXPECT_EQ(scene.labels.at(20, 20, 20), kSoftTissue);
  EXPECT_EQ(std::ranges::count(scene.labels.voxels, kVein), 0);
}

TEST(Recipe, LabelsOfTheAuthorsOwnKeepTheirNames) {
  Recipe recipe;
  recipe.labels = {{16, {"left \u00c4ste", kVein}}, {17, {"", kBone}}, {18, {"", kSoftTissue}}};
  LabelStep step;
  step.tool = step::Logical{};
  step.label = 16;
  recipe.steps.push_back(step);
  const auto read = readRecipe(textOf(recipe));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->labels, recipe.labels);
  EXPECT_EQ(read->steps[0].label, 16);

  const auto with = [](const std::string& label) {
    return readRecipe(R"({"labels": [)" + label + R"(], "steps": [{"tool": "auto"}]})");
  };
  EXPECT_EQ(with(R"({"label": 16, "name": "a\nb"})")->labels, (OwnLabels{{16, {"a b", kSoftTissue}}}));
  EXPECT_EQ(with(R"({"label": 16, "name": ")" + std::string(10'000, 'x') + "\"}")->labels[16].name.size(), 64U);
  EXPECT_THAT(with(R"({"label": 6, "name": "x"})").error().message, HasSubstr("'label'"));
  EXPECT_THAT(with(R"({"label": 16, "tissue": "stone"})").error().message, HasSubstr("not 'stone'"));
  EXPECT_THAT(with(R"({"label": 16, "tissue": "background"})").error().message, HasSubstr("'tissue'"));
}

TEST(Recipe, PresetsCanBeRead) {
  ASSERT_FALSE(recipePresets().empty());
  for (const Preset& preset : recipePresets()) {
    const auto recipe = loadRecipe(preset.name);
    ASSERT_TRUE(recipe) << recipe.error().message;
    EXPECT_FALSE(recipe->description.empty()) << preset.name;
  }
}

std::string recipeRefusal(const std::string& text) {
  const auto recipe = readRecipe(text);
  return recipe ? "accepted" : recipe.error().message;
}

std::string recipeStepRefusal(const std::string& step) {
  return recipeRefusal("{\"steps\": [{\"tool\": \"median\", \"label\": \"vein\"}, " + step + "]}");
}

TEST(Recipe, BadRecipesAreRefusedWithThePlaceAndWhatIsPossible) {
  EXPECT_THAT(recipeRefusal("{"), HasSubstr("The recipe is not valid JSON: line 1"));
  EXPECT_THAT(recipeRefusal("[]"), HasSubstr("must be an object"));
  EXPECT_THAT(recipeRefusal("{}"), HasSubstr("has no steps"));
  EXPECT_THAT(recipeRefusal(R"({"step": []})"), HasSubstr("did you mean 'steps'"));
  EXPECT_THAT(recipeStepRefusal("7"), HasSubstr("step 2 must be an object"));
  EXPECT_THAT(recipeStepRefusal(R"({"label": "vein"})"), HasSubstr("step 2 has no 'tool'"));
  EXPECT_THAT(recipeStepRefusal(R"({"tool": "tresholt"})"), HasSubstr("did you mean 'threshold'"));
  EXPECT_THAT(recipeStepRefusal(R"({"tool": "wxyz"})"), HasSubstr("it is one of auto, threshold, paint"));
  EXPECT_THAT(recipeStepRefusal(R"({"tool": "median", "label": "vein", "radius": 2})"),
              HasSubstr("step 2 (median) has an unknown 'radius'; did you mean 'radius_mm'?"));
  EXPECT_THAT(recipeStepRefusal(R"({"tool": "median", "label": "vein", "radius_mm": 5000})"),
              HasSubstr("needs a number from 0.1 to 100 as 'radius_mm', not 5000"));
  EXPECT_THAT(recipeStepRefusal(R"({"tool": "median"})"), HasSubstr("has no 'label'"));
  EXPECT_THAT(recipeStepRefusal(R"({"tool": "median", "label": "veine"})"), HasSubstr("did you mean 'vein'?"));
  EXPECT_THAT(recipeStepRefusal(R"({"tool": "median", "label": 255})"), HasSubstr("numbers from 0 to 254"));
  EXPECT_THAT(recipeStepRefusal(R"({"tool": "threshold", "label": "bone"})"), HasSubstr("has no 'range_HU'"));
  EXPECT_THAT(recipeStepRefusal(R"({"tool": "threshold", "label": "bone", "range_HU": [300, 100]})"),
              HasSubstr("[from, to]"));
  EXPECT_THAT(recipeStepRefusal(R"({"tool": "threshold", "label": "bone", "range_HU": [1e300, 1e301]})"),
              HasSubstr("[from, to]"));
  EXPECT_THAT(recipeStepRefusal(R"({"tool": "vessel", "label": "vein", "points_mm": [[0, 0, 0]]})"),
              HasSubstr("a list of 2 or more points [x, y, z]"));
  EXPECT_THAT(recipeStepRefusal(R"({"tool": "vessel", "label": "vein", "points_mm": [[0, 0], [1, 2]]})"),
              HasSubstr("points [x, y, z]"));
  EXPECT_THAT(
      recipeStepRefusal(R"({"tool": "vessel", "label": "vein", "points_mm": {"a": [0, 0, 0], "b": [1, 1, 1]}})"),
      HasSubstr("points [x, y, z]"));
  EXPECT_THAT(recipeStepRefusal(R"({"tool": "hollow", "label": "vein", "wall": "outer"})"), HasSubstr("wall 'outer'"));
  EXPECT_THAT(recipeStepRefusal(R"({"tool": "paint", "label": "vein", "points_mm": [[0, 0, 0]], "slice_axis": 3})"),
              HasSubstr("from 0 to 2"));
  EXPECT_THAT(recipeStepRefusal(
                  R"({"tool": "scissors", "label": "vein", "points_mm": [[0,0,0],[1,0,0],[0,1,0]], "along": [0,0,0]})"),
              HasSubstr("needs a direction"));
  EXPECT_THAT(recipeStepRefusal(R"({"tool": "median", "label": "vein", "box_mm": [[0, 0, 0]]})"),
              HasSubstr("two corners"));
}

TEST(Recipe, AStepThatFailsIsNamedAndThoseBeforeItStay) {
  Scene scene(test::toolGrids()[0].geometry);
  const auto recipe = readRecipe(R"({"steps": [
    {"tool": "threshold", "label": "bone", "range_HU": [400, 3000]},
    {"tool": "opening", "label": "bone", "radius_mm": 30}]})");
  ASSERT_TRUE(recipe);
  LabelEdit edit(scene.ct, scene.labels);
  const auto failed = perform(*recipe, edit);
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().message,
              HasSubstr("Step 2 (opening) of the recipe could not be done: The shape would vanish"));
  EXPECT_EQ(edit.undoName(), "threshold");
  const auto cancelled = perform(*recipe, edit, [](std::string_view, double) { return false; });
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().message, kCancelled);
}

class ScoresOnGrids : public test::OnGrids {};
INSONATE_ON_GRIDS(ScoresOnGrids);

TEST_P(ScoresOnGrids, BallsOfTwoRadiiDifferByTheirGap) {
  const auto mapOf = [&](double radius_mm) {
    LabelMap map(grid());
    const Selection chosen = ball({}, radius_mm);
    for (std::size_t v = 0; v < map.voxels.size(); ++v) map.voxels[v] = chosen.mask.voxels[v] ? kVein : kBackground;
    return map;
  };
  const auto scores = scoreLabels(mapOf(9), mapOf(12));
  ASSERT_TRUE(scores) << scores.error().message;
  ASSERT_EQ(scores->size(), 1u);
  const LabelScore& s = scores->front();
  EXPECT_EQ(s.label, kVein);
  EXPECT_NEAR(s.dice, 2 * 729.0 / (729 + 1728), 0.03);
  EXPECT_NEAR(*s.meanSurface_mm, 3, 0.6);
  EXPECT_LE(*s.meanSurface_mm, *s.p95Surface_mm + 1e-9);
  EXPECT_LT(*s.p95Surface_mm, 3 + 1.2 * std::max({grid().spacing_mm.x, grid().spacing_mm.y, grid().spacing_mm.z}));
  const auto same = scoreLabels(mapOf(9), mapOf(9));
  EXPECT_EQ(same->front().dice, 1);
  EXPECT_NEAR(*same->front().p95Surface_mm, 0, 1e-5);
}

TEST(Score, OfALabelThatOneDoesNotHaveIsZeroWithoutDistance) {
  LabelMap truth(test::toolGrids()[0].geometry);
  truth.at(3, 3, 3) = kVein;
  const auto scores = scoreLabels(LabelMap(truth.geometry), truth);
  ASSERT_TRUE(scores);
  EXPECT_EQ(scores->front().dice, 0);
  EXPECT_FALSE(scores->front().meanSurface_mm);
  EXPECT_FALSE(scoreLabels(LabelMap(test::toolGrids()[1].geometry), truth)) << "another grid";
}

}  // namespace
}  // namespace insonate
