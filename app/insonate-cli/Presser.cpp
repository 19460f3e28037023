#include "Presser.h"

#include <insonate/ultrasound/BeamGrid.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace insonate::cli {
namespace {

constexpr double kDeepest_mm = 20;
constexpr const char* kNoSkin =
    "The probe's face meets no skin within 20 mm behind it or 40 mm in front of it. Move the pose onto the skin, or "
    "use auto.";

std::string number(double value, const char* unit) {
  char text[48];
  std::snprintf(text, sizeof text, "%.3g %s", value, unit);
  return text;
}

std::string nameOf(std::uint8_t label) {
  return std::string(labelTable()[knownLabel(label)].name);
}

}  // namespace

Result<Presser> Presser::make(const ImagingSetup& setup, PressPlan plan) {
  auto tissue = CompressedTissue::make(setup.probe, setup.settings, plan.mechanics, 0, true);
  if (!tissue) return tl::unexpected(tissue.error());
  return Presser(std::move(*tissue), setup, std::move(plan));
}

double Presser::reach_mm(const PressPlan& plan) {
  return plan.indent_mm ? *plan.indent_mm + 1 : plan.force_N ? kDeepest_mm : 0;
}

Result<std::vector<Transform>> Presser::onSkin(const PressPlan& plan, const LabelMap& labels, const ImagingSetup& setup,
                                               const std::vector<Transform>& path) {
  if (!plan.indent_mm && !(plan.force_N > 0.0)) return path;
  std::vector<Transform> poses;
  for (const Transform& pose : path) {
    auto moved = poseOnSkin(labels, probeFaceOf(setup.probe, plan.mechanics), pose);
    if (!moved) return tl::unexpected(moved.error());
    poses.push_back(*moved);
  }
  return poses;
}

Result<void> Presser::press(const AcousticScene& scene, const Transform& patientFromProbe) {
  const BloodPressure blood = bloodPressure(plan_.physiology, plan_.mechanics.tissues, plan_.time_s);
  tissue_.moveLung({plan_.time_s ? lungSlideAt_mm(plan_.physiology, *plan_.time_s) : 0});
  if (!plan_.moves()) {
    tissue_.hold(scene, patientFromProbe, blood);
    return {};
  }
  const auto travel = tissue_.travelRange(scene, patientFromProbe);
  if (!travel) return fail(kNoSkin);
  if (plan_.force_N) {
    tissue_.push(scene, patientFromProbe, blood, *plan_.force_N);
    return {};
  }
  const double max_mm = travel->deepest_mm - travel->touch_mm;
  if (*plan_.indent_mm > max_mm)
    return fail("--indent " + number(*plan_.indent_mm, "mm") +
                " would move the probe's face into bone: the tissue over the bone can be compressed by " +
                number(max_mm, "mm") + " here at maximum.");
  Transform moved = patientFromProbe;
  moved.offset = patientFromProbe * Vec3{0, 0, travel->touch_mm + *plan_.indent_mm};
  tissue_.hold(scene, moved, blood);
  return {};
}

void Presser::holdAt(const AcousticScene& scene, const Transform& patientFromProbe, double time_s) {
  tissue_.moveLung({lungSlideAt_mm(plan_.physiology, time_s)});
  tissue_.hold(scene, patientFromProbe, bloodPressure(plan_.physiology, plan_.mechanics.tissues, time_s));
}

PlaneDisplacement Presser::field() const {
  if (!displacement().empty()) return displacement();
  const BeamGrid grid(setup_->probe, setup_->settings);
  PlaneDisplacement still;
  still.left_mm = grid.minLateral_mm(), still.top_mm = grid.minAxial_mm();
  still.columns = 1 + static_cast<int>(std::ceil(grid.maxLateral_mm() - still.left_mm));
  still.rows = 1 + static_cast<int>(std::ceil(grid.maxAxial_mm() - still.top_mm));
  still.restFromDisplayed.resize(std::size_t(still.columns) * still.rows);
  return still;
}

nlohmann::json Presser::report() const {
  nlohmann::json object{{"deformation", plan_.mechanics.model},
                        {"force_N", nullptr},
                        {"indent_mm", nullptr},
                        {"lumens", nlohmann::json::array()}};
  if (!givesWay()) return object;
  const Deformation& answer = tissue_.deformation();
  object["force_N"] = answer.force_N;
  if (std::isfinite(tissue_.indentation_mm())) object["indent_mm"] = std::max(tissue_.indentation_mm(), 0.0);
  for (const LumenArea& lumen : answer.lumens)
    object["lumens"].push_back(
        {{"label", nameOf(lumen.label)}, {"area_mm2", lumen.area_mm2}, {"rest_area_mm2", lumen.rest_mm2}});
  return object;
}

std::vector<std::string> Presser::warnings() const {
  std::vector<std::string> warnings;
  const Deformation& answer = tissue_.deformation();
  const std::string force = number(answer.force_N, "N");
  if (tissue_.isStopped())
    warnings.push_back("the probe stops at " + number(tissue_.indentation_mm(), "mm") + " and " + force +
                       ", before the force reaches " + number(*plan_.force_N, "N") +
                       ": it met bone, or tissue that cannot be compressed further.");
  else if (!answer.converged && plan_.force_N)
    warnings.push_back("the tissue did not come to rest under " + number(*plan_.force_N, "N") +
                       "; the image shows a force of " + force + ".");
  else if (!answer.converged)
    warnings.push_back("the tissue did not come to rest at this indentation, so positions and force are estimates.");
  return warnings;
}

}  // namespace insonate::cli
