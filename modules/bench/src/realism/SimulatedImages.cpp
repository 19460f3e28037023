#include "realism/FanInside.h"
#include "realism/ImagePlan.h"

#include <insonate/bench/AppearanceFeatures.h>
#include <insonate/bench/RealismBench.h>
#include <insonate/cases/Phantom.h>
#include <insonate/cases/StartPose.h>
#include <insonate/simulator/CompressedTissue.h>
#include <insonate/simulator/Imager.h>
#include <insonate/ultrasound/SetupText.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

namespace insonate {
namespace {

using bench::Choices, bench::ImageKind, bench::ImagePlan;

constexpr double kGainReach_dB = 24;  ///< range of the gain to either side of 0
/// The darkest twentieth of an image stays black: nine in ten real images have at most this gray there.
constexpr int kBlackest = 13;

/// Parts of a displayed image that are measured and shown.
struct ImageParts {
  PixelBox measured;
  cv::Mat mask;  ///< inside of a fan; empty for linear probes

  static ImageParts of(const BModeImage& image, const ImagingSetup& setup) {
    if (setup.probe.shape == ProbeShape::Linear) return {insideOfLinear(image, setup), {}};
    std::vector<std::uint8_t> inside = fieldOfViewMask(setup.probe, setup.settings);
    cv::Mat mask = cv::Mat(image.height, image.width, CV_8U, inside.data()).clone();
    return {bench::largestRectangle(mask), std::move(mask)};
  }
  GrayImage measuredPart(const BModeImage& image) const { return bench::cutOut(image.gray, image.width, measured); }
  GrayImage shownPart(const BModeImage& image) const {
    if (mask.empty()) return measuredPart(image);
    return bench::onlyInside({image.width, image.height, image.gray}, mask);
  }

 private:
  static PixelBox insideOfLinear(const BModeImage& image, const ImagingSetup& setup) {
    const double half_mm = setup.probe.width_mm / 2;
    const auto column = [&](double mm) { return int(std::lround((mm - image.left_mm) / image.pixel_mm)); };
    const int first = std::max(0, column(-half_mm) + 1), last = std::min(image.width, column(half_mm) - 1);
    const int top = std::max(0, int(std::lround(-image.top_mm / image.pixel_mm)) + 1);
    const int bottom =
        std::min(image.height, int(std::lround((setup.settings.depth_mm - image.top_mm) / image.pixel_mm)) - 1);
    return {first, top, last - first, bottom - top};
  }
};

/// The upper middle part, with the size of another image if possible.
GrayImage cutLike(const GrayImage& image, const GrayImage& other) {
  const int width = std::min(image.width, other.width), height = std::min(image.height, other.height);
  return bench::cutOut(image.gray, image.width, {(image.width - width) / 2, 0, width, height});
}

/// Gain as a person adjusts it: the median of the image has the planned gray, unless blood would become gray.
double adjustedGain_dB(const ImagePlan& plan, ImagingFrame& frame, const ImageParts& parts) {
  ImagingSettings settings = plan.setup.settings;
  double low_dB = -kGainReach_dB, high_dB = kGainReach_dB;
  constexpr int kHalvings = 6;
  for (int n = 0; n < kHalvings; ++n) {
    settings.gain_dB = (low_dB + high_dB) / 2;
    Display(plan.setup.probe, settings).process(frame.envelope, frame.image, frame.noiseSeed);
    GrayImage inside = parts.measuredPart(frame.image);
    const auto grayAt = [&](double share) {
      const auto place = inside.gray.begin() + std::ptrdiff_t(share * double(inside.gray.size()));
      std::nth_element(inside.gray.begin(), place, inside.gray.end());
      return *place;
    };
    const bool isTooBright = grayAt(0.5) > plan.medianGray || grayAt(0.05) > kBlackest;
    (isTooBright ? high_dB : low_dB) = settings.gain_dB;
  }
  return settings.gain_dB;
}

/// The tissue that all frames of a plan can show.
Region regionOfPlan(const ImagePlan& plan) {
  constexpr double kGivesWay_mm = 15;
  const Vec3 margin{kGivesWay_mm, kGivesWay_mm, kGivesWay_mm};
  Region all = regionOf(plan.setup.probe, plan.setup.settings, plan.middle());
  for (const Transform& pose : {plan.patientFromProbe.front(), plan.patientFromProbe.back()}) {
    const Region one = regionOf(plan.setup.probe, plan.setup.settings, pose);
    for (int axis = 0; axis < 3; ++axis) {
      all.low_mm[axis] = std::min(all.low_mm[axis], one.low_mm[axis]);
      all.high_mm[axis] = std::max(all.high_mm[axis], one.high_mm[axis]);
    }
  }
  return {all.low_mm - margin, all.high_mm + margin};
}

/// Renders the frames of one plan.
class Filming {
 public:
  static Result<Filming> make(const PatientCase& patient, const ImagePlan& plan) {
    auto scene = makeScene(patient, plan.setup, regionOfPlan(plan));
    if (!scene) return tl::unexpected(scene.error());
    auto tissue = CompressedTissue::make(plan.setup.probe, plan.setup.settings, {});
    if (!tissue) return tl::unexpected(tissue.error());
    return Filming(plan, std::move(*scene), std::move(*tissue));
  }

  /// Renders the middle frame, with the mean blood pressure, and adjusts the gain.
  Result<BModeImage> still(std::uint32_t noiseSeed) {
    auto imager = Imager::make(plan_.setup);
    if (!imager) return tl::unexpected(imager.error());
    frame_.noiseSeed = noiseSeed;
    shoot(*imager, plan_.middle(), {});
    parts_ = ImageParts::of(frame_.image, plan_.setup);
    plan_.setup.settings.gain_dB = adjustedGain_dB(plan_, frame_, parts_);
    return frame_.image;
  }
  /// Renders all frames with the gain of still(). As on a machine, compounding and persistence use earlier frames.
  Result<std::vector<BModeImage>> clip(std::uint32_t noiseSeed) {
    auto imager = Imager::make(plan_.setup, CompoundingSchedule::OneAnglePerFrame);
    if (!imager) return tl::unexpected(imager.error());
    std::vector<BModeImage> images;
    for (std::size_t n = 0; n < plan_.patientFromProbe.size(); ++n) {
      frame_.noiseSeed = noiseSeed + std::uint32_t(n);
      shoot(*imager, plan_.patientFromProbe[n], plan_.start_s + double(n) / kClipFrames_perSecond);
      images.push_back(frame_.image);
    }
    return images;
  }
  const ImageParts& parts() const { return parts_; }

 private:
  Filming(const ImagePlan& plan, std::shared_ptr<const AcousticScene> scene, CompressedTissue tissue)
      : plan_(plan), scene_(std::move(scene)), tissue_(std::move(tissue)) {}

  void shoot(Imager& imager, const Transform& pose, std::optional<double> time_s) {
    tissue_.push(*scene_, pose, bloodPressure(Physiology{}, measuredMechanics(), time_s), plan_.force_N);
    imager.render(*scene_, tissue_.pose(), tissue_.deformation().displacement, nullptr, frame_);
  }

  ImagePlan plan_;
  std::shared_ptr<const AcousticScene> scene_;
  CompressedTissue tissue_;
  ImagingFrame frame_;
  ImageParts parts_;
};

/// `like`: the real image whose size a linear probe's image takes, or null.
Result<SourceImage> simulatedImageOf(const PatientCase& patient, const std::string& neck, const ImagePlan& plan,
                                     const SourceImage* like, std::uint32_t noiseSeed) {
  auto filming = Filming::make(patient, plan);
  if (!filming) return tl::unexpected(filming.error());
  auto still = filming->still(noiseSeed);
  if (!still) return tl::unexpected(still.error());
  std::vector<BModeImage> images{std::move(*still)};
  if (plan.patientFromProbe.size() > 1) {
    auto clip = filming->clip(noiseSeed);
    if (!clip) return tl::unexpected(clip.error());
    images = std::move(*clip);
  }
  const ProbeShape shape = plan.setup.probe.shape;
  const double pixelsPer_mm = 1 / images.front().pixel_mm;
  const auto measured = [&](const BModeImage& image) -> Result<GrayImage> {
    auto scaled = atFeatureScale(filming->parts().measuredPart(image), pixelsPer_mm);
    if (scaled && like && shape == ProbeShape::Linear) return cutLike(*scaled, like->image);
    return scaled;
  };
  auto middle = measured(images[images.size() / 2]);
  if (!middle) return tl::unexpected(middle.error());
  SourceImage one{neck, neck + ", " + plan.about, std::move(*middle), shape, plan.plane};
  if (shape == ProbeShape::Linear && images.size() == 1) return one;
  for (const BModeImage& image : images) {
    if (shape != ProbeShape::Linear) {
      one.frames.push_back(bench::atShownScale(filming->parts().shownPart(image), pixelsPer_mm, shape));
      continue;
    }
    auto frame = measured(image);
    if (!frame) return tl::unexpected(frame.error());
    one.frames.push_back(std::move(*frame));
  }
  return one;
}

/// Built-in necks and the given cases in rounds, in another order each round, so that a neck is not always combined
/// with the same probe and plane.
class Patients {
 public:
  Patients(unsigned seed, const std::vector<std::filesystem::path>& cases)
      : seed_(seed), cases_(cases), choices_(seed) {
    for (const PhantomVariant& variant : phantomVariants())
      if (variant.region == PhantomRegion::kNeck) necks_.emplace_back(variant.name);
  }

  struct Patient {
    PatientCase data;
    std::string name;
    std::vector<StartPose> views;
  };
  Result<Patient> next() {
    const std::size_t place = count_++ % (necks_.size() + cases_.size());
    if (place == 0) shuffle();
    const std::size_t turn = order_[place];
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
  void shuffle() {
    order_.resize(necks_.size() + cases_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    for (std::size_t n = order_.size(); n > 1; --n) std::swap(order_[n - 1], order_[choices_.index(n)]);
  }

  unsigned seed_;
  const std::vector<std::filesystem::path>& cases_;
  std::vector<std::string> necks_;
  Choices choices_;
  std::vector<std::size_t> order_;
  std::size_t count_ = 0;
};

/// Kinds of the images of a set, and the real images that they resemble.
class Kinds {
 public:
  Kinds(const SimulatedSet& set, const std::vector<SourceImage>& real) : set_(set), real_(real) {}

  /// The real image that image `n` resembles, null if there is none of its probe.
  const SourceImage* likeOf(std::size_t n) const {
    if (set_.probes.empty()) return real_.empty() ? nullptr : &real_[n % real_.size()];
    std::vector<const SourceImage*> same;
    for (const SourceImage& image : real_)
      if (image.probe == set_.probes[n % set_.probes.size()]) same.push_back(&image);
    return same.empty() ? nullptr : same[n / set_.probes.size() % same.size()];
  }
  ImageKind kindOf(std::size_t n) {
    const SourceImage* const like = likeOf(n);
    ImageKind kind;
    if (!set_.probes.empty())
      kind.probe = set_.probes[n % set_.probes.size()];
    else if (like)
      kind.probe = like->probe;
    // All probes get all planes, whatever the numbers of both.
    if (!set_.planes.empty())
      kind.plane = set_.planes[n / std::max<std::size_t>(1, set_.probes.size()) % set_.planes.size()];
    else if (like)
      kind.plane = like->plane;
    kind.clip = set_.clips || (like && like->isClip());
    kind.sweeps = kind.clip && clips_++ % 2 == 1;
    return kind;
  }

 private:
  const SimulatedSet& set_;
  const std::vector<SourceImage>& real_;
  int clips_ = 0;
};

}  // namespace

Result<std::vector<SourceImage>> simulatedImages(const SimulatedSet& set, const std::vector<SourceImage>& real,
                                                 const Progress& progress) {
  const auto tissues = loadAcousticTable("neck");
  if (!tissues) return tl::unexpected(tissues.error());
  std::map<ProbeShape, Probe> probes;
  for (const ProbeShape shape : {ProbeShape::Linear, ProbeShape::Curvilinear, ProbeShape::Phased}) {
    const auto probe = loadProbe(nameOf(shape));
    if (!probe) return tl::unexpected(probe.error());
    probes.emplace(shape, *probe);
  }
  Patients patients(set.seed, set.cases);
  Choices choices(set.seed);
  Kinds kinds(set, real);
  std::vector<SourceImage> images;
  while (int(images.size()) < set.count) {
    if (!report(progress, "simulating images", double(images.size()) / set.count)) return fail(std::string(kCancelled));
    const auto patient = patients.next();
    if (!patient) return tl::unexpected(patient.error());
    const ImageKind kind = kinds.kindOf(images.size());
    const auto plan = bench::planImage(patient->data, patient->views, probes.at(kind.probe), *tissues, kind, choices);
    if (!plan) return tl::unexpected(plan.error());
    auto image = simulatedImageOf(patient->data, patient->name, *plan, kinds.likeOf(images.size()),
                                  std::uint32_t(images.size()) * kClipFrames);
    if (!image) return tl::unexpected(image.error());
    images.push_back(std::move(*image));
  }
  return images;
}

}  // namespace insonate
