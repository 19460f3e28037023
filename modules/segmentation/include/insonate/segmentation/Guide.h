#pragma once

#include <insonate/core/Preset.h>
#include <insonate/segmentation/LabelStep.h>
#include <insonate/segmentation/Recipe.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Range of a number.
struct GuideRange {
  double low = 0, high = 0;
};

/// Side of the patient.
enum class GuideSide { Right, Left };

/// One way of doing a step of a guide.
struct GuideWay {
  std::optional<HuRange> clicks_HU{};  ///< it is for clicks on what is so bright; any without
  std::optional<double> around_mm{};   ///< its steps stay so near to the clicks
  std::vector<LabelStep> steps;        ///< without their points: these are the clicks
  std::string caution{};               ///< what to be aware of in what it makes
};

/// One step of the guide: the author's task, the view, and the expected result.
struct GuideStep {
  std::string name;                 ///< "vein-right"
  std::string title;                ///< "Jugular vein, right"
  std::optional<GuideSide> side;    ///< on which its clicks are
  std::uint8_t label = 0;           ///< what it makes; none for a step that makes several
  std::string vessel;               ///< name of the vein or artery that it makes, e.g. "right internal jugular vein"
  std::string say;                  ///< what to do
  std::string lookFor, ifWrong;     ///< what a good result looks like, what else to do
  int leastClicks = 0, clicks = 0;  ///< that it needs, that usually do; none for a step that runs by itself
  bool optional = false;            ///< not needed for training
  std::vector<GuideWay> ways;       ///< the first that fits is taken
  std::vector<std::uint8_t> makes;  ///< labels that should be there after it, beside its own
  std::vector<std::uint8_t> apart;  ///< labels that should not touch it
  std::optional<GuideRange> diameter_mm, volume_ml;  ///< of what it makes, with the source in the file
};

/// Steps through which a CT is labeled, in this order.
struct Guide {
  std::string description;
  std::vector<GuideStep> steps;
};

/// Reads a JSON object with `steps`. Fails with the step, the error in it, and the possible values.
Result<Guide> readGuide(std::string_view text);

/// Guides that are compiled in.
const std::vector<Preset>& guidePresets();

/// The way of doing a step of the guide that fits these clicks (patient, mm), its steps with their points as a recipe
/// would hold them. Refuses too few clicks, clicks beside the CT, and clicks that no way is for.
Result<GuideWay> wayFor(const GuideStep& step, std::span<const Vec3> clicks_mm, const CtVolume& ct);

/// Clicks of a step of the guide, by the recipe's first step with points that was made for it; none without.
std::vector<Vec3> clicksOf(const GuideStep& step, const Recipe& recipe);

/// Returns findings about the result of a step, one sentence each: whether it contains the clicks, has a usual width
/// and size, and keeps apart from structures that it must not touch. Takes a fraction of a second. The labels may be
/// of any time after the step.
std::vector<std::string> findingsAbout(const GuideStep& step, std::span<const Vec3> clicks_mm, const LabelMap& labels);

}  // namespace insonate
