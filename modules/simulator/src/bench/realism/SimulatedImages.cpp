#include "bench/realism/PictureParts.h"

#include <insonate/cases/Phantom.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/LookFeatures.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/simulator/RealismBench.h>
#include <insonate/ultrasound/GrayMaps.h>
#include <insonate/ultrasound/Machine.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <numbers>
#include <random>

namespace insonate {
namespace {

constexpr int kImagesOfANeck = 2;
constexpr double kOtherMap = 0.5;     ///< share of the images with another gray map than their machine's
constexpr double kPoorContact = 0.3;  ///< share of those where an end of the probe does not touch the skin

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
  std::string about;
};

/// Settings as people choose them for a neck at a machine: its own, moved as far as real images differ in brightness,
/// contrast and depth.
ImagingSettings chosenSettings(ImagingSettings settings, const Probe& probe, Choices& choices) {
  settings.depth_mm = std::round(choices.between(30, 45));
  const double frequency_MHz = settings.frequency_MHz + choices.between(-1.5, 1.5);
  settings.frequency_MHz =
      std::clamp(std::round(2 * frequency_MHz) / 2, probe.minFrequency_MHz, probe.maxFrequency_MHz);
  settings.focus_mm = std::round(settings.depth_mm * choices.between(0.35, 0.65));
  settings.gain_dB = std::round(settings.gain_dB + choices.between(-10, 11));
  settings.dynamicRange_dB = std::round(std::clamp(settings.dynamicRange_dB + choices.between(-12, 18), 40.0, 80.0));
  if (choices.between(0, 1) < kOtherMap) settings.grayMap = grayMaps()[choices.index(grayMaps().size())].map;
  double* const end = choices.between(0, 1) < 0.5 ? &settings.poorContactLeft_mm : &settings.poorContactRight_mm;
  if (choices.between(0, 1) < kPoorContact) *end = std::round(choices.between(1, 7));
  return settings;
}

/// The start pose moved along the skin and turned about its axis, on one of the machines.
Result<Drawn> drawn(const PatientCase& patient, const Probe& probe, const AcousticTable& tissues, Choices& choices) {
  const StartPose& view = patient.manifest.startPoses[choices.index(patient.manifest.startPoses.size())];
  const double turn = choices.between(-20, 20) * std::numbers::pi / 180;
  const Vec3 elevation = cross(view.axial, view.lateral);
  const auto pose =
      patientFromProbe(view.position_mm + view.lateral * choices.between(-4, 4) + elevation * choices.between(-8, 8),
                       view.axial, view.lateral * std::cos(turn) + elevation * std::sin(turn));
  if (!pose) return tl::unexpected(pose.error());
  const Machine& machine = machines()[choices.index(machines().size())];
  const auto own = settingsOf(machine.name, probe, settingsFor(probe));
  if (!own) return tl::unexpected(own.error());
  const ImagingSettings settings = chosenSettings(*own, probe, choices);
  Drawn one{{probe, settings, tissues}, *pose, {}};
  char text[200];
  std::snprintf(
      text, sizeof text, "%s, %s, turned %.0f degrees, %.0f mm, %.1f MHz, gain %.0f dB, range %.0f dB, map %s",
      machine.name.c_str(), view.name.c_str(), turn * 180 / std::numbers::pi, settings.depth_mm, settings.frequency_MHz,
      settings.gain_dB, settings.dynamicRange_dB, std::string(curveOf(settings.grayMap).name).c_str());
  one.about = text;
  return one;
}

/// The inside of a linear probe's field of view.
GreyPicture insideOf(const BModeImage& image, const Drawn& of) {
  const double half_mm = of.setup.probe.width_mm / 2;
  const auto column = [&](double mm) { return int(std::lround((mm - image.left_mm) / image.pixel_mm)); };
  const int first = std::max(0, column(-half_mm) + 1), last = std::min(image.width, column(half_mm) - 1);
  const int top = std::max(0, int(std::lround(-image.top_mm / image.pixel_mm)) + 1);
  const int bottom =
      std::min(image.height, int(std::lround((of.setup.settings.depth_mm - image.top_mm) / image.pixel_mm)) - 1);
  return bench::cutOut(image.grey, image.width, {first, top, last - first, bottom - top});
}

/// The upper middle part, as large as another image where it can be.
GreyPicture cutLike(const GreyPicture& image, const GreyPicture& other) {
  const int width = std::min(image.width, other.width), height = std::min(image.height, other.height);
  return bench::cutOut(image.grey, image.width, {(image.width - width) / 2, 0, width, height});
}

Result<SourceImage> imageOf(const PatientCase& patient, const std::string& neck, const Drawn& one,
                            std::uint32_t noiseSeed) {
  const auto scene = makeScene(patient, one.setup, regionOf(one.setup.probe, one.setup.settings, one.patientFromProbe));
  if (!scene) return tl::unexpected(scene.error());
  auto imager = Imager::make(one.setup);
  if (!imager) return tl::unexpected(imager.error());
  ImagingFrame frame;
  frame.noiseSeed = noiseSeed;
  imager->render(**scene, one.patientFromProbe, frame);
  auto scaled = atLookScale(insideOf(frame.image, one), 1 / frame.image.pixel_mm);
  if (!scaled) return tl::unexpected(scaled.error());
  return SourceImage{neck, neck + ", " + one.about, std::move(*scaled)};
}

}  // namespace

Result<std::vector<SourceImage>> simulatedImages(int count, unsigned seed, const std::vector<SourceImage>& real,
                                                 const Progress& progress) {
  const auto probe = loadProbe("linear");
  if (!probe) return tl::unexpected(probe.error());
  const auto tissues = loadAcousticTable("neck");
  if (!tissues) return tl::unexpected(tissues.error());
  std::vector<std::string> necks;
  for (const PhantomVariant& variant : phantomVariants())
    if (variant.name != "subclavian") necks.emplace_back(variant.name);
  Choices choices(seed);
  std::vector<SourceImage> images;
  for (int neck = 0; int(images.size()) < count; ++neck) {
    if (!report(progress, "simulating images", double(images.size()) / count)) return fail(std::string(kCancelled));
    const std::string& variant = necks[std::size_t(neck) % necks.size()];
    const auto patient = makePhantom(variant, seed * 1000 + unsigned(neck));
    if (!patient) return tl::unexpected(patient.error());
    for (int n = 0; n < kImagesOfANeck && int(images.size()) < count; ++n) {
      const auto one = drawn(*patient, *probe, *tissues, choices);
      if (!one) return tl::unexpected(one.error());
      auto image = imageOf(*patient, variant, *one, static_cast<std::uint32_t>(images.size()));
      if (!image) return tl::unexpected(image.error());
      if (!real.empty()) image->image = cutLike(image->image, real[images.size() % real.size()].image);
      images.push_back(std::move(*image));
    }
  }
  return images;
}

}  // namespace insonate
