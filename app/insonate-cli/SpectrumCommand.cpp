#include "Commands.h"
#include "Interrupt.h"
#include "PressOptions.h"
#include "Presser.h"
#include "RenderOutputs.h"

#include <insonate/cases/HeartDistance.h>
#include <insonate/cases/TissueLabels.h>
#include <insonate/core/JsonEntry.h>
#include <insonate/core/Preset.h>
#include <insonate/simulator/MovingBlood.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/ultrasound/SpectralDoppler.h>

#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>

namespace insonate::cli {
namespace {

/// Time between two spectra of the waterfall.
constexpr double kColumn_s = 0.005;

struct SpectrumOptions {
  std::string caseFolder, probe = "linear", pose = "auto", gate, out;
  double seconds = 3;
  PressOptions press;
  bool json = false;
};

Result<SpectralSettings> readGate(const std::string& source) {
  if (source.empty()) return SpectralSettings{};
  const bool inlined = source.starts_with('{');
  const auto text = inlined ? Result<std::string>(source) : readTextFile(source);
  if (!text) return tl::unexpected(text.error());
  const auto json = parsedJson(*text, inlined ? "--gate" : source);
  if (!json) return tl::unexpected(json.error());
  auto gate = spectralFromJson(*json, {});
  if (!gate) return fail((inlined ? "--gate: " : source + ": ") + gate.error().message);
  return gate;
}

Result<void> writeWaterfall(const std::vector<std::vector<double>>& spectra, const SpectralSettings& gate,
                            const std::string& file) {
  constexpr std::uint8_t kBaselineGray = 128;
  SpectrumImage waterfall = waterfallOf(spectra, gate, 1);
  BModeImage image;
  image.width = waterfall.columns, image.height = kSpectrumBins, image.pixel_mm = 0.25;
  image.gray = std::move(waterfall.gray);
  int baseline = 0;
  while (rowVelocity_mmps(gate, baseline) > 0) ++baseline;
  std::fill_n(image.gray.begin() + std::ptrdiff_t(baseline) * image.width, image.width, kBaselineGray);
  return writePng(image, file);
}

/// The tissue is compressed at the mean blood pressure; the flow follows the time.
Result<nlohmann::json> measure(const SpectrumOptions& options) {
  if (auto ok = checkTargets(
          {.picture = options.out, .envelope = {}, .displacement = {}, .layers = {}, .mMode = {}, .suffix = {}},
          options.caseFolder);
      !ok)
    return tl::unexpected(ok.error());
  ImagingSetup setup;
  auto probe = loadProbe(options.probe);
  if (!probe) return tl::unexpected(probe.error());
  setup.probe = *probe, setup.settings = settingsFor(*probe);
  auto tissues = loadAcousticTable("neck");
  if (!tissues) return tl::unexpected(tissues.error());
  setup.tissues = std::move(*tissues);
  const auto gate = readGate(options.gate);
  if (!gate) return tl::unexpected(gate.error());
  if (auto ok = validate(*gate, setup.probe, setup.settings); !ok) return tl::unexpected(ok.error());
  auto press = readPress(options.press, false);
  if (!press) return tl::unexpected(press.error());
  const double start_s = press->time_s.value_or(0);
  press->time_s.reset();
  setup.mechanics = press->mechanics;
  auto read = readCase(options.caseFolder);
  if (!read) return tl::unexpected(read.error());
  PatientCase& patient = read->patient;
  replaceOwnLabels(patient);
  press->physiology.siteAboveHeart_mm = siteAboveHeart_mm(patient.manifest);
  auto path = readPoses(options.pose, patient);
  if (!path) return tl::unexpected(path.error());
  if (path->isPath) return fail("spectrum takes one pose, not a path of poses.");
  auto onSkin = Presser::onSkin(*press, patient.labels, setup, path->patientFromProbe);
  if (!onSkin) return tl::unexpected(onSkin.error());
  auto presser = Presser::make(setup, *press);
  if (!presser) return tl::unexpected(presser.error());
  const auto scene =
      makeScene(patient, setup, sceneRegion(setup, onSkin->front(), Presser::reach_mm(*press)), terminalProgress());
  if (!scene) return tl::unexpected(scene.error());
  if (auto ok = presser->press(**scene, onSkin->front()); !ok) return tl::unexpected(ok.error());

  if (patient.manifest.vessels.empty())
    std::cerr << "The case names no vessels, so no blood flows: the spectrum shows only noise and moving tissue.\n";
  MovingBlood blood(patient.manifest.vessels, &patient.labels);
  SpectralDoppler doppler(setup.probe, setup.settings, *gate);
  std::vector<std::vector<double>> spectra(static_cast<std::size_t>(options.seconds / kColumn_s));
  double mean = 0, highest = -HUGE_VAL, lowest = HUGE_VAL;
  for (std::size_t column = 0; column < spectra.size(); ++column) {
    if (interruptSignal() != 0) return fail(std::string(kCancelled));
    const BloodFlow& flow =
        blood.at(press->physiology, start_s + double(column) * kColumn_s, presser->displacement(), presser->pose());
    if (column == 0) doppler.hold(**scene, presser->pose(), presser->displacement(), flow);
    doppler.spectrum(flow, {}, spectra[column]);
    const SpectrumVelocities velocities = velocitiesOf(spectra[column], *gate);
    mean += velocities.mean_mmps / double(spectra.size());
    highest = std::max(highest, velocities.envelope_mmps), lowest = std::min(lowest, velocities.envelope_mmps);
  }
  if (auto ok = writeWaterfall(spectra, *gate, options.out); !ok) return tl::unexpected(ok.error());
  return nlohmann::json{{"out", options.out},          {"nyquist_mmps", nyquistVelocity_mmps(*gate)},
                        {"mean_mmps", mean},           {"envelope_max_mmps", highest},
                        {"envelope_min_mmps", lowest}, {"seconds_per_column", kColumn_s},
                        {"gate", jsonOf(*gate)}};
}

void spectrum(const SpectrumOptions& options, Outcome& outcome) {
  outcome.json = options.json;
  const auto report = measure(options);
  if (!report) return refuse(outcome, report.error());
  if (options.json) return printJson(*report);
  std::cout << options.out << '\n';
}

}  // namespace

void addSpectrumCommand(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<SpectrumOptions>();
  CLI::App* command =
      app.add_subcommand("spectrum", "Write the spectrum of the velocities of blood in a gate over time (PW Doppler)");
  command->add_option("CASE", options->caseFolder, "Case folder")->required()->check(notEmpty());
  command->add_option("--probe", options->probe, "Probe: linear, curvilinear, phased, or a probe file")
      ->capture_default_str();
  command
      ->add_option("--pose", options->pose,
                   "Pose of the probe: auto, the name of a start pose of the case, a JSON file, or JSON text")
      ->capture_default_str();
  command->add_option("--gate", options->gate,
                      "JSON file or JSON text with settings of the gate: across (0 to 1), range_mm, gate_mm, "
                      "steering_deg, angle_deg, prf_Hz, frequency_MHz, wallFilter_Hz, gain_dB, baseline");
  command->add_option("--seconds", options->seconds, "Duration of the waterfall, s")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 60.0));
  command->add_option("--out", options->out, "PNG to write, with one column for each 5 ms")
      ->required()
      ->check(notEmpty());
  options->press.addTo(*command);
  command->add_flag("--json", options->json, "Print a JSON object with the velocities");
  command->callback([options, &outcome] { spectrum(*options, outcome); });
}

}  // namespace insonate::cli
