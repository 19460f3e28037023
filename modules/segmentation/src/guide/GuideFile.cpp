#include "recipe/StepFile.h"

#include <insonate/embedded/guides.h>
#include <insonate/segmentation/Guide.h>
#include <insonate/tissue/Labels.h>

namespace insonate {
namespace {

using nlohmann::json;
using segmentation::Points;
using segmentation::StepReader;

std::optional<GuideRange> rangeOf(JsonEntry& entry, const json& object, const char* key) {
  if (!entry.has(key)) return std::nullopt;
  const json& range = object[key];
  if (range.is_array() && range.size() == 2 && range[0].is_number() && range[1].is_number() && range[0] >= 0 &&
      range[0] < range[1])
    return GuideRange{range[0], range[1]};
  entry.setError("needs [from, to] as '" + std::string(key) + "'.");
  return std::nullopt;
}

GuideMethod readWay(const json& object, const std::string& where, std::string& error) {
  const std::vector<std::string_view> known{"clicks_HU", "least_clicks", "around_mm", "steps", "caution", "comment"};
  JsonEntry entry(object, where, known, error);
  GuideMethod way;
  way.around_mm = entry.optionalNumber("around_mm", 1, 100);
  way.minClicks = entry.optionalInteger("least_clicks", 1, 20).value_or(0);
  way.caution = entry.text("caution", false);
  way.steps = entry.list("steps", "step", [](const json& step, const std::string& whereStep, std::string& wrong) {
    return segmentation::readStep(step, whereStep, wrong, Points::kLater);
  });
  if (entry.error().empty() && way.steps.empty()) entry.setError("has no steps in its list 'steps'.");
  StepReader reader(object, where, known, Points::kLater, error);
  reader("clicks_HU", way.clicks_HU);
  return way;
}

GuideStep readGuideStep(const json& object, const std::string& where, std::string& error) {
  const std::vector<std::string_view> known{"name",  "title",        "label",     "say",      "look_for", "if_wrong",
                                            "side",  "least_clicks", "clicks",    "optional", "ways",     "makes",
                                            "apart", "diameter_mm",  "volume_ml", "source",   "comment",  "vessel"};
  JsonEntry entry(object, where, known, error);
  GuideStep step;
  step.name = entry.text("name");
  step.title = entry.text("title");
  step.instruction = entry.text("say");
  step.lookFor = entry.text("look_for");
  step.ifWrong = entry.text("if_wrong");
  step.vessel = entry.text("vessel", false);
  step.minClicks = entry.optionalInteger("least_clicks", 1, 20).value_or(0);
  step.clicks = entry.optionalInteger("clicks", 1, 20).value_or(step.minClicks);
  if (step.clicks < step.minClicks) entry.setError("needs more clicks in 'least_clicks' than in 'clicks'.");
  if (entry.has("side")) step.side = static_cast<GuideSide>(entry.word("side", {"right", "left"}));
  step.optional = entry.has("optional") && entry.flag("optional");
  step.ways = entry.list("ways", "way", readWay);
  if (entry.error().empty() && step.ways.empty())
    entry.setError("has an empty list 'ways'. Add at least one way to label the structure.");
  step.diameter_mm = rangeOf(entry, object, "diameter_mm");
  step.volume_ml = rangeOf(entry, object, "volume_ml");
  StepReader reader(object, where, known, Points::kLater, error);
  reader("label", step.label);
  reader("makes", step.makes);
  reader("apart", step.apart);
  if (step.clicks > 0 && step.label == 0) reader.setError("has clicks but no 'label': name the one that they are for.");
  if (!step.vessel.empty() && step.label != kVein && step.label != kArtery)
    reader.setError("names a 'vessel' but its 'label' is neither vein nor artery.");
  return step;
}

}  // namespace

Result<Guide> readGuide(std::string_view text) {
  const auto file = parsedJson(text, "The guide");
  if (!file) return tl::unexpected(file.error());
  JsonEntry entry(*file, "The guide", {"description", "steps"});
  Guide guide;
  guide.description = entry.text("description", false);
  guide.steps = entry.list("steps", "step", readGuideStep);
  if (entry.error().empty() && guide.steps.empty()) entry.setError("has no steps in its list 'steps'.");
  if (!entry.error().empty()) return fail(entry.error());
  return guide;
}

const std::vector<Preset>& guidePresets() {
  static const std::vector<Preset> kPresets = embeddedPresets(embedded::guides::files());
  return kPresets;
}

}  // namespace insonate
