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

/// One of several ways to perform a step of the guide.
struct GuideMethod {
  /// range of CT values of the clicked tissue for which this method is used; empty: any values
  std::optional<HuRange> clicks_HU{};
  int minClicks = 0;  ///< minimum number of clicks for this method; 0: GuideStep::minClicks
  /// Labeling steps may change only voxels within this distance of the clicks; empty: no limit.
  std::optional<double> around_mm{};
  std::vector<LabelStep> steps;  ///< labeling steps; the author's clicks become their points
  std::string caution{};         ///< warning to the author about the result
};

/// One step of the guide: the author's task, the view, and the expected result.
struct GuideStep {
  std::string name;               ///< identifier of the step, e.g. "vein-right"
  std::string title;              ///< title of the step for the user, e.g. "Jugular vein, right"
  std::optional<GuideSide> side;  ///< side of the patient on which to click
  std::uint8_t label = 0;         ///< label of the result; 0 for a step that makes several labels
  std::string vessel;             ///< name of the vein or artery in the result, e.g. "right internal jugular vein"
  std::string instruction;        ///< instruction to the author
  /// lookFor: appearance of a correct result; ifWrong: advice in case of a wrong result
  std::string lookFor, ifWrong;
  /// minClicks: minimum number of clicks; clicks: number of clicks that usually suffices; both 0 for a step without
  /// clicks
  int minClicks = 0, clicks = 0;
  bool optional = false;  ///< true if the step is not needed for training
  /// alternative methods to perform the step; the first one whose clicks_HU fits the clicked tissue is used
  std::vector<GuideMethod> ways;
  std::vector<std::uint8_t> makes;  ///< labels that should exist after the step, in addition to `label`
  std::vector<std::uint8_t> apart;  ///< labels of structures that should not touch the result
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

/// Returns the guides that are compiled into the program.
const std::vector<Preset>& guidePresets();

/// Returns the first method of a guide's step that fits the CT values at these clicks (patient space). The labeling
/// steps of the returned method contain the clicks as points. Fails if there are too few clicks, if a click lies
/// outside the CT, or if no method fits the CT values of the clicks.
Result<GuideMethod> methodFor(const GuideStep& step, std::span<const Vec3> clicks_mm, const CtVolume& ct);

/// Returns the number of clicks that the step needs: that of the method that fits the CT values at the clicks so far.
/// Without clicks in the CT, and if no method fits, it is GuideStep::minClicks.
int clicksNeeded(const GuideStep& step, std::span<const Vec3> clicks_mm, const CtVolume& ct);

/// Returns the clicks with which the author performed a step of the guide. They are the points of the first labeling
/// step in `recipe` that has points and was made for this step of the guide (LabelStep::of). Empty if the recipe has no
/// such step.
std::vector<Vec3> clicksOf(const GuideStep& step, const Recipe& recipe);

/// A finding about the result of a step of the guide.
struct GuideFinding {
  std::string text;
  /// false: the author cannot accept the result in spite of the finding, because a vessel does not contain its clicks.
  bool canBeAccepted = true;
};

/// Checks the result of a step of the guide. There is a finding if the result does not contain the clicks, has an
/// unusual mean width or volume, if a vessel is unusually narrow or wide anywhere or its width jumps, or if the result
/// touches structures that it should not touch. Takes a fraction of a second. The labels
/// may have been edited since the step.
std::vector<GuideFinding> checkGuideStep(const GuideStep& step, std::span<const Vec3> clicks_mm,
                                         const LabelMap& labels);

}  // namespace insonate
