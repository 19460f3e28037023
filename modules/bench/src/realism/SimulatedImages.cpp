#include "realism/PictureParts.h"

#include <insonate/bench/LookFeatures.h>
#include <insonate/bench/RealismBench.h>
#include <insonate/cases/Phantom.h>
#include <insonate/cases/StartPose.h>
#include <insonate/image/Volume.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/PressedTissue.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/ultrasound/Display.h>
#include <insonate/ultrasound/GrayMaps.h>
#include <insonate/ultrasound/Machine.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <numbers>
#include <random>

namespace insonate {
namespace {

constexpr double kLargestForce_N = 4;  ///< light to firm compression with the whole face
constexpr double kOtherMap = 0.25;     ///< share of the images with a gray map other than their machine's
constexpr double kPoorContact = 0.3;   ///< share of the images in which one end of the probe does not touch the skin
/// Median gray to which a person sets the gain, and the range of the gain: 39 real neck images of 15 sources have a
/// median of 65, four of five lie between 25 and 110; the seven local images are darker (31).
constexpr double kDarkest = 20, kBrightest = 100, kGainReach_dB = 24;
/// The darkest twentieth of an image stays black: nine in ten real images have at most this gray there.
constexpr int kBlackest = 13;
constexpr double kTgcStep_dB = 1.5;  ///< TGC sliders are never exactly equal

class Choices {
 public:
  explicit Choices(unsigned seed) : random_(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  std::size_t index(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }

 private:
  std::mt19937 random_;
};

struct Drawn {
  ImagingSetup setup;
  Transform patientFromProbe;
  double force_N = 0;  ///< compression force of the probe
  double medianGray = 0;
  std::string about;
};

/// Settings as people choose them for a neck: those of the machine, varied as real images vary in brightness, contrast
/// and depth.
ImagingSettings chosenSettings(ImagingSettings settings, const Probe& probe, Choices& choices) {
  settings.depth_mm = std::round(choices.between(30, 45));
  const double frequency_MHz = settings.frequency_MHz + choices.between(-1.5, 1.5);
  settings.frequency_MHz =
      std::clamp(std::round(2 * frequency_MHz) / 2, probe.minFrequency_MHz, probe.maxFrequency_MHz);
  settings.focus_mm = std::round(settings.depth_mm * choices.between(0.35, 0.65));
  for (double& slider_dB : settings.tgc_dB) slider_dB += choices.between(-kTgcStep_dB, kTgcStep_dB);
  settings.dynamicRange_dB = std::round(std::clamp(settings.dynamicRange_dB + choices.between(-10, 12), 45.0, 80.0));
  if (choices.between(0, 1) < kOtherMap) settings.grayMap = grayMaps()[choices.index(grayMaps().size())].map;
  double* const end = choices.between(0, 1) < 0.5 ? &settings.poorContactLeft_mm : &settings.poorContactRight_mm;
  if (choices.between(0, 1) < kPoorContact) *end = std::round(choices.between(1, 7));
  return settings;
}

/// A start pose moved along the skin and turned about its axis.
struct Turned {
  const StartPose* view;
  Transform patientFromProbe;
  double turn_rad;
};

Result<Turned> turned(const StartPose& view, Choices& choices) {
  const double turn = choices.between(-20, 20) * std::numbers::pi / 180;
  const Vec3 elevation = cross(view.axial, view.lateral);
  const auto pose =
      patientFromProbe(view.position_mm + view.lateral * choices.between(-4, 4) + elevation * choices.between(-8, 8),
                       view.axial, view.lateral * std::cos(turn) + elevation * std::sin(turn));
  if (!pose) return tl::unexpected(pose.error());
  return Turned{&view, *pose, turn};
}

/// True if tissue lies below both ends of the face. There is no tissue outside the volume.
bool isOnTheBody(const PatientCase& patient, const Probe& probe, const Transform& patientFromProbe) {
  constexpr double kBelow_mm = 4;
  const Transform index = patient.labels.geometry.indexFromPatient();
  return std::ranges::all_of(std::array{-0.5, 0.5}, [&](double end) {
    return sampleNearest(patient.labels, index * (patientFromProbe * Vec3{end * probe.width_mm, 0, kBelow_mm})) !=
           kBackground;
  });
}

/// A pose at which the whole face touches the skin, and a machine.
Result<Drawn> drawn(const PatientCase& patient, const std::vector<StartPose>& views, const Probe& probe,
                    const AcousticTable& tissues, Choices& choices) {
  constexpr int kTries = 20;
  auto place = turned(views[choices.index(views.size())], choices);
  for (int n = 0; n < kTries && place && !isOnTheBody(patient, probe, place->patientFromProbe); ++n)
    place = turned(views[choices.index(views.size())], choices);
  if (!place) return tl::unexpected(place.error());
  if (!isOnTheBody(patient, probe, place->patientFromProbe))
    return fail("The whole face of the probe finds no skin near the start poses of " + patient.manifest.title +
                ". Leave this case out, or give it start poses farther from the ends of its volume.");
  const Machine& machine = machines()[choices.index(machines().size())];
  const auto own = settingsOf(machine.name, probe, settingsFor(probe));
  if (!own) return tl::unexpected(own.error());
  const ImagingSettings settings = chosenSettings(*own, probe, choices);
  Drawn one{{probe, settings, tissues}, place->patientFromProbe, choices.between(0, kLargestForce_N), 0, {}};
  one.medianGray = kDarkest * std::pow(kBrightest / kDarkest, choices.between(0, 1));
  char text[200];
  std::snprintf(text, sizeof text,
                "%s, %s, turned %.0f degrees, %.1f N, %.0f mm, %.1f MHz, median %.0f, range %.0f dB, map %s",
                machine.name.c_str(), place->view->name.c_str(), place->turn_rad * 180 / std::numbers::pi, one.force_N,
                settings.depth_mm, settings.frequency_MHz, one.medianGray, settings.dynamicRange_dB,
                std::string(curveOf(settings.grayMap).name).c_str());
  one.about = text;
  return one;
}

/// The inside of a linear probe's field of view.
GreyPicture insideOfSimulated(const BModeImage& image, const Drawn& of) {
  const double half_mm = of.setup.probe.width_mm / 2;
  const auto column = [&](double mm) { return int(std::lround((mm - image.left_mm) / image.pixel_mm)); };
  const int first = std::max(0, column(-half_mm) + 1), last = std::min(image.width, column(half_mm) - 1);
  const int top = std::max(0, int(std::lround(-image.top_mm / image.pixel_mm)) + 1);
  const int bottom =
      std::min(image.height, int(std::lround((of.setup.settings.depth_mm - image.top_mm) / image.pixel_mm)) - 1);
  return bench::cutOut(image.grey, image.width, {first, top, last - first, bottom - top});
}

/// The upper middle part, with the size of another image if possible.
GreyPicture cutLike(const GreyPicture& image, const GreyPicture& other) {
  const int width = std::min(image.width, other.width), height = std::min(image.height, other.height);
  return bench::cutOut(image.grey, image.width, {(image.width - width) / 2, 0, width, height});
}

/// Sets the gain as a person does, until the median of the image has the drawn gray, or until blood would become gray.
void adjustGain(const Drawn& one, ImagingFrame& frame) {
  ImagingSettings settings = one.setup.settings;
  double low_dB = -kGainReach_dB, high_dB = kGainReach_dB;
  constexpr int kHalvings = 6;
  for (int n = 0; n < kHalvings; ++n) {
    settings.gain_dB = (low_dB + high_dB) / 2;
    Display(one.setup.probe, settings).process(frame.envelope, frame.image, frame.noiseSeed);
    GreyPicture inside = insideOfSimulated(frame.image, one);
    const auto grayAt = [&](double share) {
      const auto place = inside.grey.begin() + std::ptrdiff_t(share * double(inside.grey.size()));
      std::nth_element(inside.grey.begin(), place, inside.grey.end());
      return *place;
    };
    const bool isTooBright = grayAt(0.5) > one.medianGray || grayAt(0.05) > kBlackest;
    (isTooBright ? high_dB : low_dB) = settings.gain_dB;
  }
}

Result<SourceImage> simulatedImageOf(const PatientCase& patient, const std::string& neck, const Drawn& one,
                                     std::uint32_t noiseSeed) {
  constexpr double kGivesWay_mm = 15;
  Region region = regionOf(one.setup.probe, one.setup.settings, one.patientFromProbe);
  const Vec3 margin{kGivesWay_mm, kGivesWay_mm, kGivesWay_mm};
  region.low_mm = region.low_mm - margin, region.high_mm = region.high_mm + margin;
  const auto scene = makeScene(patient, one.setup, region);
  if (!scene) return tl::unexpected(scene.error());
  auto tissue = PressedTissue::make(one.setup.probe, one.setup.settings, {});
  if (!tissue) return tl::unexpected(tissue.error());
  tissue->push(**scene, one.patientFromProbe, bloodPressure(Physiology{}, measuredMechanics()), one.force_N);
  auto imager = Imager::make(one.setup);
  if (!imager) return tl::unexpected(imager.error());
  ImagingFrame frame;
  frame.noiseSeed = noiseSeed;
  imager->render(**scene, tissue->pose(), tissue->deformation().displacement, nullptr, frame);
  adjustGain(one, frame);
  auto scaled = atLookScale(insideOfSimulated(frame.image, one), 1 / frame.image.pixel_mm);
  if (!scaled) return tl::unexpected(scaled.error());
  return SourceImage{neck, neck + ", " + one.about, std::move(*scaled)};
}

/// Built-in necks and the given cases in turn, one patient after another.
class Patients {
 public:
  Patients(unsigned seed, const std::vector<std::filesystem::path>& cases) : seed_(seed), cases_(cases) {
    for (const PhantomVariant& variant : phantomVariants())
      if (variant.name != "subclavian") necks_.emplace_back(variant.name);
  }

  struct Patient {
    PatientCase data;
    std::string name;
    std::vector<StartPose> views;
  };
  Result<Patient> next() {
    const std::size_t turn = count_++ % (necks_.size() + cases_.size());
    if (turn < necks_.size()) {
      auto neck = makePhantom(necks_[turn], seed_ * 1000 + unsigned(count_ - 1));
      if (!neck) return tl::unexpected(neck.error());
      std::vector<StartPose> views = neck->manifest.startPoses;
      return Patient{std::move(*neck), necks_[turn], std::move(views)};
    }
    const std::filesystem::path& folder = cases_[turn - necks_.size()];
    auto read = readCase(folder);
    if (!read) return tl::unexpected(read.error());
    std::vector<StartPose> views = read->patient.manifest.startPoses;
    if (views.empty()) {
      const auto found = autoStartPose(read->patient);
      if (!found) return tl::unexpected(found.error());
      views.push_back(*found);
    }
    return Patient{std::move(read->patient), folder.filename().string(), std::move(views)};
  }

 private:
  unsigned seed_;
  const std::vector<std::filesystem::path>& cases_;
  std::vector<std::string> necks_;
  std::size_t count_ = 0;
};

}  // namespace

Result<std::vector<SourceImage>> simulatedImages(const SimulatedSet& set, const std::vector<SourceImage>& real,
                                                 const Progress& progress) {
  const auto probe = loadProbe("linear");
  if (!probe) return tl::unexpected(probe.error());
  const auto tissues = loadAcousticTable("neck");
  if (!tissues) return tl::unexpected(tissues.error());
  Patients patients(set.seed, set.cases);
  Choices choices(set.seed);
  std::vector<SourceImage> images;
  while (int(images.size()) < set.count) {
    if (!report(progress, "simulating images", double(images.size()) / set.count)) return fail(std::string(kCancelled));
    const auto patient = patients.next();
    if (!patient) return tl::unexpected(patient.error());
    const auto one = drawn(patient->data, patient->views, *probe, *tissues, choices);
    if (!one) return tl::unexpected(one.error());
    auto image = simulatedImageOf(patient->data, patient->name, *one, std::uint32_t(images.size()));
    if (!image) return tl::unexpected(image.error());
    if (!real.empty()) image->image = cutLike(image->image, real[images.size() % real.size()].image);
    images.push_back(std::move(*image));
  }
  return images;
}

}  // namespace insonate
