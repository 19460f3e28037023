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

/// Range of expected values.
struct GuideRange {
  double low = 0, high = 0;
};

/// Side of the patient.
enum class GuideSide { Right, Left };

/// One of the alternative ways to do a step of a guide.
struct GuideWay {
  std::optional<HuRange> clicks_HU{};  ///< CT values of the clicked tissue for which this way is used; any if empty
  /// Limits the steps to voxels within this distance of the clicks; no limit if empty.
  std::optional<double> around_mm{};
  std::vector<LabelStep> steps;  ///< labeling steps without points; the author's clicks become their points
  std::string caution{};         ///< warning to the author about the result
};

/// One step of the guide: the author's task, the view, and the expected result.
struct GuideStep {
  std::string name;                 ///< identifier of the step, e.g. "vein-right"
  std::string title;                ///< title of the step for the user, e.g. "Jugular vein, right"
  std::optional<GuideSide> side;    ///< side of the patient on which to click
  std::uint8_t label = 0;           ///< label of the result; 0 for a step that makes several labels
  std::string vessel;               ///< name of the vein or artery in the result, e.g. "right internal jugular vein"
  std::string say;                  ///< instruction to the author
  std::string lookFor, ifWrong;     ///< lookFor: appearance of a good result; ifWrong: advice if the result is bad
  int leastClicks = 0, clicks = 0;  ///< leastClicks: clicks that are required; clicks: clicks that usually suffice;
                                    ///< both 0 for an automatic step
  bool optional = false;            ///< true if the step is not needed for training
  std::vector<GuideWay> ways;       ///< alternatives; the first one that fits the clicks is taken
  std::vector<std::uint8_t> makes;  ///< labels, besides `label`, that should exist after the step
  std::vector<std::uint8_t> apart;  ///< labels that should not touch the result
  /// Expected diameter and volume of the result; the guide's file states the source.
  std::optional<GuideRange> diameter_mm, volume_ml;
};

/// Steps by which an author labels a CT, in order.
struct Guide {
  std::string description;
  std::vector<GuideStep> steps;
};

/// Reads a guide from a JSON object with `steps`. Fails with the step, the error in it, and the possible values.
Result<Guide> readGuide(std::string_view text);

/// Returns the guides that are compiled in.
const std::vector<Preset>& guidePresets();

/// Returns the first way of doing a step of the guide that fits these clicks (patient, mm). Its steps contain the
/// clicks as points, as in a recipe. Refuses too few clicks, clicks outside the CT, and clicks on a brightness that
/// fits no way.
Result<GuideWay> wayFor(const GuideStep& step, std::span<const Vec3> clicks_mm, const CtVolume& ct);

/// Returns the clicks of a step of the guide: the points of the recipe's first step that was made for this step of the
/// guide and has points. Empty if there is no such step.
std::vector<Vec3> clicksOf(const GuideStep& step, const Recipe& recipe);

/// A sentence about the result of a step.
struct GuideFinding {
  std::string text;
  /// False if the result is wrong even though an author accepts it: a vessel without the clicks that are to lie in it.
  bool canBeAccepted = true;
};

/// Checks the result of a step and returns findings: the result does not contain the clicks, has an
/// unusual width or volume, or touches structures that it must not touch. Takes a fraction of a second. The labels may
/// have been edited since the step.
std::vector<GuideFinding> findingsAbout(const GuideStep& step, std::span<const Vec3> clicks_mm, const LabelMap& labels);

}  // namespace insonate
