#include "Commands.h"
#include "Interrupt.h"
#include "MModeOptions.h"
#include "NeedleOptions.h"
#include "PointOptions.h"
#include "Presser.h"
#include "RenderOutputs.h"
#include "RodFile.h"

#include <insonate/cases/HeartDistance.h>
#include <insonate/cases/TissueLabels.h>
#include <insonate/core/Hash.h>
#include <insonate/core/JsonEntry.h>
#include <insonate/core/Preset.h>
#include <insonate/simulator/DisplacementFile.h>
#include <insonate/simulator/EffectLayers.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/MovingBlood.h>
#include <insonate/simulator/PointScene.h>
#include <insonate/simulator/PoseChecks.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/ultrasound/Machine.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <iostream>
#include <map>
#include <memory>
#include <set>

namespace insonate::cli {
namespace {

struct RenderOptions {
  std::string caseFolder, probe = "linear", pose = "auto", engine = "auto", machine, tissues, settings, look, points;
  std::optional<std::string> color;
  OutputTargets targets;
  PressOptions press;
  NeedleOptions needle;
  MModeOptions mMode;
  std::vector<std::string> wires;
  bool json = false;
};

/// The options' files and values, read and checked.
struct RenderJob {
  PatientCase patient;
  ImagingSetup setup;
  PosePath path;
  PressPlan press;
  NeedlePlan needle;
  std::vector<std::string> warnings;
  std::vector<PointTarget> points = {};  ///< patient LPS
  std::vector<FlexibleRod> rods = {};
};

/// `source` is a JSON text, the name of a JSON file, or empty for the default settings.
Result<ColorSettings> readColor(const std::string& source, const ImagingSetup& setup) {
  const ColorSettings base = colorSettingsFor(setup.probe, setup.settings);
  if (source.empty()) return base;
  const bool inlined = source.starts_with('{');
  const auto text = inlined ? Result<std::string>(source) : readTextFile(source);
  if (!text) return tl::unexpected(text.error());
  const auto json = parsedJson(*text, inlined ? "--color" : source);
  if (!json) return tl::unexpected(json.error());
  auto color = colorFromJson(*json, base);
  if (!color) return fail((inlined ? "--color: " : source + ": ") + color.error().message);
  return color;
}

Result<ImagingSetup> readSetup(const RenderOptions& options) {
  ImagingSetup setup;
  setup.engine = options.engine;
  auto probe = loadProbe(options.probe);
  if (!probe) return tl::unexpected(probe.error());
  setup.probe = *probe;
  setup.settings = settingsFor(setup.probe);
  if (!options.machine.empty()) {
    auto settings = settingsOf(options.machine, setup.probe, setup.settings);
    if (!settings) return tl::unexpected(settings.error());
    setup.settings = *settings;
  }
  if (!options.settings.empty()) {
    auto settings = loadSettings(options.settings, setup.settings);
    if (!settings) return tl::unexpected(settings.error());
    setup.settings = *settings;
  }
  if (options.color) {
    auto color = readColor(*options.color, setup);
    if (!color) return tl::unexpected(color.error());
    setup.color = *color;
  }
  if (!options.look.empty()) setup.settings.look = options.look == "thesis" ? Look::Thesis : Look::Coherent;
  const bool thesis = setup.settings.look == Look::Thesis;
  auto tissues = loadAcousticTable(!options.tissues.empty() ? options.tissues : thesis ? "thesis" : "neck");
  if (!tissues) return tl::unexpected(tissues.error());
  setup.tissues = std::move(*tissues);
  return setup;
}

Result<RenderJob> readJob(const RenderOptions& options) {
  if (auto ok = checkTargets(options.targets, options.caseFolder); !ok) return tl::unexpected(ok.error());
  auto setup = readSetup(options);
  if (!setup) return tl::unexpected(setup.error());
  auto press = readPress(options.press, !options.targets.displacement.empty());
  if (!press) return tl::unexpected(press.error());
  setup->mechanics = press->mechanics;
  auto needle = readNeedle(options.needle);
  if (!needle) return tl::unexpected(needle.error());
  auto read = readCase(options.caseFolder);
  if (!read) return tl::unexpected(read.error());
  replaceOwnLabels(read->patient);
  press->physiology.siteAboveHeart_mm = siteAboveHeart_mm(read->patient.manifest);
  auto path = readPoses(options.pose, read->patient);
  if (!path) return tl::unexpected(path.error());
  RenderJob job{std::move(read->patient), std::move(*setup), std::move(*path),
                std::move(*press),        *needle,           std::move(read->notes)};
  if (auto ok = checkPosesTouchVolume(job.patient, job.setup, job.path.patientFromProbe); !ok)
    return tl::unexpected(ok.error());
  auto onSkin = Presser::onSkin(job.press, job.patient.labels, job.setup, job.path.patientFromProbe);
  if (!onSkin) return tl::unexpected(onSkin.error());
  job.path.patientFromProbe = std::move(*onSkin);
  if (!options.points.empty()) {
    auto points = readPoints(options.points);
    if (!points) return tl::unexpected(points.error());
    for (PointTarget& point : *points) point.position_mm = job.path.patientFromProbe.front() * point.position_mm;
    job.points = std::move(*points);
  }
  for (const std::string& file : options.wires) {
    auto rod = readRod(file);
    if (!rod) return tl::unexpected(rod.error());
    job.rods.push_back(std::move(*rod));
  }
  job.warnings.insert(job.warnings.end(), job.path.warnings.begin(), job.path.warnings.end());
  for (std::string& warning : poseWarnings(job.patient, job.setup, job.path.patientFromProbe))
    job.warnings.push_back(std::move(warning));
  return job;
}

nlohmann::json jsonOf(const Transform& patientFromProbe) {
  const StartPose pose = toStartPose(patientFromProbe);
  return {{"position_mm", jsonArray(pose.position_mm)},
          {"axial", jsonArray(pose.axial)},
          {"lateral", jsonArray(pose.lateral)}};
}

nlohmann::json jsonOf(const Needle& needle) {
  return {{"tip_mm", jsonArray(needle.tip_mm)}, {"direction", jsonArray(needle.direction)}};
}

nlohmann::json stagesOf(const ImagingFrame& frame) {
  nlohmann::json stages = nlohmann::json::object();
  for (const ImagingFrame::Stage& stage : frame.stages) stages[stage.name] = stage.ms;
  return stages;
}

/// Poses of a path have noise of their own, and a pose has the same whatever path it is on.
std::uint32_t noiseSeed(const Transform& patientFromProbe) {
  std::uint32_t seed = 0;
  for (const Vec3& v : {patientFromProbe.offset, patientFromProbe.linear.column[0], patientFromProbe.linear.column[2]})
    for (int axis = 0; axis < 3; ++axis) {
      const auto bits = std::bit_cast<std::uint64_t>(v[axis]);
      seed = hash32(seed ^ static_cast<std::uint32_t>(bits ^ bits >> 32));
    }
  return seed;
}

bool isSilent(const EnvelopeFrame& envelope) {
  return std::ranges::all_of(envelope.amplitude, [](float amplitude) { return amplitude == 0; });
}

/// Renders a path and writes what was asked for; collects the JSON objects of the pictures.
class PathRenderer {
 public:
  PathRenderer(const RenderJob& job, const OutputTargets& targets, const MModeOptions& mMode)
      : job_(job), targets_(targets), mMode_(mMode), blood_(job.patient.manifest.vessels, &job.patient.labels) {
    if (job.setup.color && job.patient.manifest.vessels.empty())
      warn("The case names no vessels, so that color Doppler shows no flow. Name its vessels in Prepare.");
    for (const std::string& warning : job.warnings) warn(warning);
  }

  Result<void> run() {
    auto imager = Imager::make(job_.setup);
    if (!imager) return tl::unexpected(imager.error());
    auto presser = Presser::make(job_.setup, job_.press);
    if (!presser) return tl::unexpected(presser.error());
    for (const SceneRun& run : sceneRuns(job_.setup, job_.path.patientFromProbe, Presser::reach_mm(job_.press))) {
      const auto scene = makePointScene(job_.patient, job_.setup, run.region, job_.points, terminalProgress());
      if (!scene) return tl::unexpected(scene.error().message == kCancelled ? cancelled() : scene.error());
      for (const std::string& warning : (*scene)->warnings()) warn(warning);
      for (std::size_t i = run.first; i < run.first + run.count; ++i)
        if (auto ok = renderOne(*imager, *presser, **scene, i); !ok)
          return ok.error().message == kCancelled ? tl::unexpected(cancelled()) : ok;
    }
    return {};
  }

  /// Times are those of the middle frame when there are several.
  nlohmann::json report() const {
    const ImagingSettings& settings = job_.setup.settings;
    std::vector<nlohmann::json> byTime = images_;
    const auto middle = byTime.begin() + static_cast<std::ptrdiff_t>(byTime.size() / 2);
    std::nth_element(byTime.begin(), middle, byTime.end(),
                     [](const auto& a, const auto& b) { return a["frame_ms"] < b["frame_ms"]; });
    nlohmann::json object = images_.front();
    object.update({{"frame_ms", (*middle)["frame_ms"]}, {"stages_ms", (*middle)["stages_ms"]}});
    object.update({{"engine", frame_.engine},
                   {"engine_note", frame_.engineNote},
                   {"look", settings.look == Look::Thesis ? "thesis" : "coherent"},
                   {"probe", job_.setup.probe.name},
                   {"tissues", job_.setup.tissues.name},
                   {"scanlines", settings.scanlines},
                   {"samples", settings.samples},
                   {"width", settings.width},
                   {"height", settings.height},
                   {"mm_per_pixel", frame_.image.pixel_mm},
                   {"warnings", warnings_}});
    if (job_.path.isPath) object["images"] = images_;
    return object;
  }

  const std::vector<std::string>& warnings() const { return warnings_; }
  const std::vector<nlohmann::json>& images() const { return images_; }

 private:
  void warn(const std::string& warning) {
    if (warned_.insert(warning).second) warnings_.push_back(warning);
  }

  /// Images of a path that are done stay.
  Error cancelled() const {
    if (images_.empty()) return {std::string(kCancelled)};
    return {"Canceled: the first " + std::to_string(images_.size()) + " of " +
            std::to_string(job_.path.patientFromProbe.size()) + " images were written."};
  }

  Result<void> renderOne(Imager& imager, Presser& presser, const AcousticScene& scene, std::size_t index) {
    if (interruptSignal() != 0) return fail(std::string(kCancelled));
    if (auto ok = presser.press(scene, job_.path.patientFromProbe[index]); !ok) return ok;
    const std::string which = job_.path.isPath ? "At pose " + std::to_string(index) + ' ' : "At this pose ";
    for (const std::string& warning : presser.warnings()) warn(which + warning);
    const Transform& pose = presser.pose();
    const OutputTargets targets = job_.path.isPath ? targets_.numbered(index) : targets_;
    nlohmann::json image = presser.report();
    image.update({{"out", targets.picture}, {"pose", jsonOf(pose)}});
    if (!targets.layers.empty()) {
      auto files = writeLayers(scene, presser, targets);
      if (!files) return tl::unexpected(files.error());
      image["layers"] = *files;
    }
    frame_.noiseSeed = noiseSeed(pose);
    renderWithNeedle(imager, scene, presser, frame_);
    if (job_.needle.needle) image["needle"] = jsonOf(job_.needle.needleAt(pose));
    if (isSilent(frame_.envelope))
      warn("The image" + (job_.path.isPath ? " of pose " + std::to_string(index) : std::string()) +
           " shows no echoes, because the probe does not touch tissue. Move the probe onto the skin.");
    if (job_.setup.color) image["color"] = colorReport();
    image["frame_ms"] = frame_.frame_ms;
    image["stages_ms"] = stagesOf(frame_);
    if (!targets.envelope.empty()) {
      image["envelope"] = targets.envelope;
      if (auto ok = writeEnvelope(frame_.envelope, job_.setup.probe, job_.setup.settings, targets.envelope); !ok)
        return ok;
    }
    if (!targets.displacement.empty()) {
      image["displacement"] = targets.displacement;
      const PlaneDisplacement field = presser.field();
      if (auto ok = writeDisplacement(job_.needle.dented(field, dent_, pose), pose, targets.displacement); !ok)
        return ok;
    }
    if (!targets.mMode.empty()) {
      image["mmode"] = targets.mMode;
      if (auto ok = writeMMode(mMode_, job_.setup, scene, presser, job_.press.time_s.value_or(0), noiseSeed(pose),
                               targets.mMode);
          !ok)
        return ok;
    }
    images_.push_back(std::move(image));
    return writePng(frame_.image, frame_.color, targets.picture);
  }

  /// Flow of the vessels at the time of the image: volume flow, and the velocity in the middle of the vessel's center
  /// line.
  nlohmann::json colorReport() const {
    nlohmann::json vessels = nlohmann::json::array();
    for (std::size_t v = 0; v < frame_.motion.blood->tubes.size(); ++v) {
      const BloodTube& tube = frame_.motion.blood->tubes[v];
      const VesselFlow flow = blood_.model().volumeFlow(v);
      vessels.push_back({{"name", blood_.model().vessels()[v].name},
                         {"flow_mlPerMin", flow.now_mm3ps * 0.06},
                         {"mean_flow_mlPerMin", flow.mean_mm3ps * 0.06},
                         {"center_velocity_mmps", tube.course[tube.course.size() / 2].scale * tube.profile_mmps[0]}});
    }
    return {{"nyquist_mmps", nyquistVelocity_mmps(*job_.setup.color)},
            {"vessels", vessels},
            {"settings", jsonOf(*job_.setup.color)}};
  }

  void renderWithNeedle(Imager& imager, const AcousticScene& scene, const Presser& presser, ImagingFrame& frame) {
    const Transform& pose = presser.pose();
    const PlaneDisplacement& displacement = job_.needle.dented(presser.displacement(), dent_, pose);
    if (job_.setup.color) frame.motion.blood = &blood_.at(job_.press.physiology, job_.press.time_s, displacement, pose);
    if (!job_.needle.needle) return imager.render(scene, pose, displacement, {nullptr, job_.rods}, frame);
    const Needle needle = job_.needle.needleAt(pose);
    imager.render(scene, pose, displacement, {&needle, job_.rods}, frame);
  }

  Result<nlohmann::json> writeLayers(const AcousticScene& scene, const Presser& presser, const OutputTargets& targets) {
    std::map<std::string, BModeImage> pictures;
    nlohmann::json files;
    for (const EffectLayer& layer : effectLayers(job_.setup.settings)) {
      if (interruptSignal() != 0) return fail(std::string(kCancelled));
      ImagingSetup setup = job_.setup;
      setup.settings = layer.settings;
      auto imager = Imager::make(setup);
      if (!imager) return tl::unexpected(imager.error());
      ImagingFrame frame;
      renderWithNeedle(*imager, scene, presser, frame);
      const std::string name = layer.name + targets.suffix + ".png";
      files[layer.name] = targets.layers + "/" + name;
      pictures[name] = std::move(frame.image);
    }
    if (auto ok = writePictures(pictures, targets.layers); !ok) return tl::unexpected(ok.error());
    return files;
  }

  const RenderJob& job_;
  const OutputTargets& targets_;
  const MModeOptions& mMode_;
  MovingBlood blood_;
  ImagingFrame frame_;
  TentedTissue dent_;
  std::vector<nlohmann::json> images_;
  std::vector<std::string> warnings_;
  std::set<std::string> warned_;
};

void render(const RenderOptions& options, Outcome& outcome) {
  outcome.json = options.json;
  const auto job = readJob(options);
  if (!job) return refuse(outcome, job.error());
  PathRenderer renderer(*job, options.targets, options.mMode);
  if (auto ok = renderer.run(); !ok) return refuse(outcome, ok.error());
  for (const std::string& warning : renderer.warnings()) std::cerr << "insonate-cli: " << warning << '\n';
  if (options.json) return printJson(renderer.report());
  for (const nlohmann::json& image : renderer.images()) std::cout << image["out"].get<std::string>() << '\n';
}

}  // namespace

void addRenderCommand(CLI::App& app, Outcome& outcome) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command =
      app.add_subcommand("render", "Render one ultrasound image of a case, or many along a path of poses");
  command->add_option("CASE", options->caseFolder, "Case folder")->required()->check(notEmpty());
  command->add_option("--probe", options->probe, "Probe: linear, curvilinear, phased, or a probe file")
      ->capture_default_str();
  command
      ->add_option("--pose", options->pose,
                   "Pose of the probe: auto, the name of a start pose of the case, a JSON file, or JSON text with "
                   "position_mm, axial and lateral (patient LPS); a list of poses makes a path")
      ->capture_default_str();
  command
      ->add_option("--out", options->targets.picture, "PNG to write; for a path of poses F.png becomes F_0000.png, ...")
      ->required()
      ->check(notEmpty());
  command->add_option("--engine", options->engine, "Engine: auto, cpu, glsl or reference")->capture_default_str();
  command->add_option(
      "--tissues", options->tissues,
      "Acoustic properties of tissue: a preset or a file; by default neck, or thesis with --style thesis");
  command
      ->add_option("--machine", options->machine,
                   "Class of ultrasound machines whose settings are applied (see machines)")
      ->check(notEmpty());
  command->add_option("--settings", options->settings,
                      "JSON file of imaging settings, which override those of the probe or of --machine");
  command->add_option("--style,--look", options->look, "Rendering style: coherent or thesis")
      ->check(CLI::IsMember({"coherent", "thesis"}));
  command
      ->add_option("--color", options->color,
                   "Draw color Doppler over the image. A JSON file or JSON text may change its settings: left, right, "
                   "near_mm, far_mm (the box), steering_deg, prf_Hz, frequency_MHz, gain_dB, wallFilter_Hz, priority, "
                   "packet, mode (velocity or power), invert")
      ->expected(0, 1);
  command->add_option("--layers", options->targets.layers,
                      "Folder for additional images, each with only one effect of the ultrasound model");
  command->add_option("--envelope", options->targets.envelope,
                      "NRRD to write, with the linear echo amplitude without compounding");
  command->add_option("--displacement", options->targets.displacement,
                      "NRRD to write, with vectors from the displaced position of the tissue to its position at rest "
                      "(mm, patient LPS)");
  command->add_option("--points", options->points,
                      "Point targets, to measure the point spread function: depths in mm below the middle of the face, "
                      "such as 5,10,20, or a file with lateral,elevation,depth in each line. In a path of poses, the "
                      "point targets stay where they are in the patient at the first pose");
  options->mMode.addTo(*command, options->targets.mMode);
  options->press.addTo(*command);
  options->needle.addTo(*command);
  command->add_option("--wire", options->wires,
                      "File with a guidewire or catheter that the image shows (see wire --out); may be given again");
  command->add_flag("--json", options->json, "Print a JSON object with times and warnings");
  command->callback([options, &outcome] { render(*options, outcome); });
}

}  // namespace insonate::cli
