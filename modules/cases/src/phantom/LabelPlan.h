#pragma once

#include <insonate/core/Result.h>
#include <insonate/core/Vec3.h>
#include <insonate/tissue/Labels.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// Parameters of the body to build around structures; lengths in mm.
struct CompletionPlan {
  double skin_mm = 1.8;  ///< thickness of the skin, 0.5 to 5
  double fat_mm = 5;     ///< mean thickness of the subcutaneous fat, 0 to 60
  double margin_mm = 2;  ///< distance between the outermost structures and the fat, 0 to 30
  std::uint32_t seed = 1;
};

struct TubePlan {
  struct Knot {
    Vec3 p_mm;
    double radius_mm;
  };
  std::vector<Knot> knots;  ///< points of the tube's center line, at least two
  Label label = kAirway;
  Label wall = kCartilage;
  double wall_mm = 0;
};

struct TargetPlan {
  std::string name;
  std::int32_t number = 0;
  double z_mm = 0;
};

/// Contents of a map file, read and checked; see CaseFromLabels.h.
struct LabelPlan {
  std::map<std::int32_t, Label> labels;
  std::optional<Label> others;
  std::string title;
  std::optional<std::pair<Vec3, Vec3>> crop_mm;
  std::vector<TubePlan> tubes;
  std::optional<CompletionPlan> complete;
  std::vector<TargetPlan> targets;
  std::map<std::int32_t, std::string> vessels;  ///< names of vessels, by the file's numbers
};

Result<LabelPlan> readLabelPlan(const std::filesystem::path& file);

}  // namespace insonate
