#include "PressOptions.h"

#include <cstdio>
#include <sstream>

namespace insonate::cli {
namespace {

constexpr int kPatience = 200;  // a vein that closes takes its time
constexpr double kMaxForce_N = 50, kMaxIndent_mm = 20;

Result<void> checkOption(const char* option, const std::optional<double>& value, double low, double high,
                         const char* unit) {
  if (!value || (*value >= low && *value <= high)) return {};
  std::ostringstream text;
  text << option << " is " << *value << "; the allowed range is " << low << " to " << high << ' ' << unit << '.';
  return fail(text.str());
}

/// "120/80".
Result<void> readPressure(const std::string& text, Physiology& physiology) {
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lf/%lf%c", &physiology.systolic_mmHg, &physiology.diastolic_mmHg, &rest) != 2)
    return fail("--pressure " + text + " is not systolic over diastolic, in mmHg, such as 120/80.");
  return {};
}

Result<Physiology> readPhysiology(const PressOptions& options) {
  Physiology physiology;
  if (!options.pressure.empty() && options.map_mmHg)
    return fail("--map and --pressure both set the arterial pressure. Give only one of them.");
  if (!options.pressure.empty())
    if (auto ok = readPressure(options.pressure, physiology); !ok) return tl::unexpected(ok.error());
  if (options.map_mmHg) {
    const double pulse_mmHg = physiology.systolic_mmHg - physiology.diastolic_mmHg;
    physiology.diastolic_mmHg = *options.map_mmHg - pulse_mmHg / 3;
    physiology.systolic_mmHg = physiology.diastolic_mmHg + pulse_mmHg;
  }
  if (options.pneumothorax) physiology.lungSlide_mm = 0;
  physiology.centralVenous_mmHg = options.cvp_mmHg.value_or(physiology.centralVenous_mmHg);
  physiology.tilt_deg = options.trendelenburg_deg.value_or(physiology.tilt_deg);
  if (auto ok = checkPhysiology(physiology); !ok) return tl::unexpected(ok.error());
  return physiology;
}

bool saysPhysiology(const PressOptions& o) {
  return o.cvp_mmHg || o.trendelenburg_deg || o.map_mmHg || o.time_s || !o.pressure.empty();
}

}  // namespace

void PressOptions::addTo(CLI::App& command) {
  auto* force = command.add_option("--force", force_N, "Contact force to which the tissue is compressed, N");
  command.add_option("--indent", indent_mm, "Indentation of the tissue from first contact, mm")->excludes(force);
  command.add_option("--deformation", deformation,
                     "Deformation model: none, column, elastic or reference; by default elastic if an option needs the "
                     "deformation, otherwise none");
  command.add_option("--mechanics", mechanics,
                     "Mechanical properties of tissue: a preset or a file; by default measured");
  command.add_option("--footprint", footprint_mm,
                     "Width of the probe's housing perpendicular to the image plane, mm; by default 10");
  command.add_flag("--sticking", sticking, "Let the tissue stick to the probe's face instead of sliding along it");
  command.add_flag("--pneumothorax", pneumothorax,
                   "The lung does not slide along the pleura while the patient breathes");
  command.add_option("--cvp", cvp_mmHg, "Central venous pressure, mmHg; by default 4");
  command.add_option("--trendelenburg", trendelenburg_deg, "Tilt of the table, degrees; positive: head down");
  command.add_option("--map", map_mmHg, "Mean arterial pressure, mmHg");
  command.add_option("--pressure", pressure, "Arterial pressure, systolic over diastolic, mmHg; by default 120/80");
  command.add_option(
      "--time", time_s,
      "Time in the cycles of heartbeat and breathing, s; by default all pressures have their mean values");
}

Result<PressPlan> readPress(const PressOptions& options, bool displacementRequested) {
  if (auto ok = checkOption("--force", options.force_N, 0, kMaxForce_N, "N"); !ok) return tl::unexpected(ok.error());
  if (auto ok = checkOption("--indent", options.indent_mm, 0, kMaxIndent_mm, "mm"); !ok)
    return tl::unexpected(ok.error());
  if (auto ok = checkOption("--time", options.time_s, 0, 1e6, "s"); !ok) return tl::unexpected(ok.error());
  auto physiology = readPhysiology(options);
  if (!physiology) return tl::unexpected(physiology.error());

  PressPlan plan;
  plan.physiology = *physiology;
  plan.force_N = options.force_N, plan.indent_mm = options.indent_mm, plan.time_s = options.time_s;
  const bool wanted = plan.moves() || displacementRequested || saysPhysiology(options) || !options.mechanics.empty() ||
                      options.sticking || options.footprint_mm;
  plan.mechanics.model = !options.deformation.empty() ? options.deformation
                         : wanted                     ? TissueMechanics{}.model
                                                      : std::string(kNoDeformation);
  if (plan.force_N && plan.mechanics.model == kNoDeformation)
    return fail("--force needs a deformation model. Remove --deformation none, or use --indent instead of --force.");
  if (!options.mechanics.empty()) {
    auto tissues = loadMechanicalTable(options.mechanics);
    if (!tissues) return tl::unexpected(tissues.error());
    plan.mechanics.tissues = std::move(*tissues);
  }
  plan.mechanics.footprint_mm = options.footprint_mm.value_or(plan.mechanics.footprint_mm);
  plan.mechanics.sticking = options.sticking;
  plan.mechanics.settings.maxIterations = kPatience;
  if (auto ok = validate(plan.mechanics); !ok) return tl::unexpected(ok.error());
  return plan;
}

}  // namespace insonate::cli
