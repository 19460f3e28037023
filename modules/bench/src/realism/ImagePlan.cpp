#include "realism/ImagePlan.h"

#include <insonate/image/Volume.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/GrayMaps.h>
#include <insonate/ultrasound/Machine.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace insonate::bench {
namespace {

constexpr double kLargestForce_N = 4;  ///< light to firm compression with the whole face
constexpr double kOtherMap = 0.25;     ///< share of the images with a gray map other than their machine's
constexpr double kPoorContact = 0.3;   ///< share of the images in which one end of the probe does not touch the skin
/// Median gray to which a person sets the gain: 39 real neck images of 15 sources have a median of 65, four of five lie
/// between 25 and 110; the seven local images are darker (31).
constexpr double kDarkest = 20, kBrightest = 100;
constexpr double kTgcStep_dB = 1.5;  ///< TGC sliders are never exactly equal
constexpr double kDegree = std::numbers::pi / 180;
/// Slow movement of a probe in a clip: along its elevation axis, and tilt about the lateral axis.
constexpr double kFastestSlide_mmPerS = 8, kFastestTilt_degPerS = 6;
/// Unsteadiness of a hand that holds a probe still: amplitude and frequency.
constexpr double kTremor_mm = 0.1, kTremor_perS = 1.3;

struct DepthRange {
  double min_mm, max_mm, frequencySpread_MHz;
};

/// Depths that show a neck, and variation of the frequency about the machine's own.
DepthRange depthRange(ProbeShape shape) {
  return shape == ProbeShape::Linear ? DepthRange{30, 45, 1.5} : DepthRange{50, 90, 0.7};
}

/// Settings as people choose them for a neck: those of the machine, varied as real images vary in brightness, contrast
/// and depth.
ImagingSettings chosenSettings(ImagingSettings settings, const Probe& probe, Choices& choices) {
  const DepthRange range = depthRange(probe.shape);
  settings.depth_mm =
      std::clamp(std::round(choices.between(range.min_mm, range.max_mm)), probe.minDepth_mm, probe.maxDepth_mm);
  const double frequency_MHz =
      settings.frequency_MHz + choices.between(-range.frequencySpread_MHz, range.frequencySpread_MHz);
  settings.frequency_MHz =
      std::clamp(std::round(2 * frequency_MHz) / 2, probe.minFrequency_MHz, probe.maxFrequency_MHz);
  settings.focus_mm = std::round(settings.depth_mm * choices.between(0.35, 0.65));
  for (double& slider_dB : settings.tgc_dB) slider_dB += choices.between(-kTgcStep_dB, kTgcStep_dB);
  settings.dynamicRange_dB = std::round(std::clamp(settings.dynamicRange_dB + choices.between(-10, 12), 45.0, 80.0));
  if (choices.happens(kOtherMap)) settings.grayMap = grayMaps()[choices.index(grayMaps().size())].map;
  double* const end = choices.happens(0.5) ? &settings.poorContactLeft_mm : &settings.poorContactRight_mm;
  if (choices.happens(kPoorContact)) *end = std::round(choices.between(1, 7));
  return settings;
}

/// Start poses of the wanted plane; all of them if there are none of this plane.
std::vector<const StartPose*> candidates(std::span<const StartPose> views, ScanPlane plane) {
  std::vector<const StartPose*> all, wanted;
  for (const StartPose& view : views) {
    all.push_back(&view);
    if (planeOf(view) == plane) wanted.push_back(&view);
  }
  return wanted.empty() ? all : wanted;
}

/// Angle by which a pose is turned about its axis to show the wanted plane.
double turnTo(ScanPlane plane, const StartPose& view, Choices& choices) {
  const ScanPlane now = planeOf(view);
  if (plane == now) return choices.between(-15, 15) * kDegree;
  if (plane == ScanPlane::Oblique || now == ScanPlane::Oblique)
    return (choices.happens(0.5) ? 1 : -1) * choices.between(35, 55) * kDegree;
  return (90 + choices.between(-15, 15)) * kDegree;
}

/// A start pose moved along the skin and turned about its axis.
struct Turned {
  const StartPose* view;
  Transform patientFromProbe;
  double turn_rad;
};

Result<Turned> turned(std::span<const StartPose> views, ScanPlane plane, Choices& choices) {
  const std::vector<const StartPose*> poses = candidates(views, plane);
  const StartPose& view = *poses[choices.index(poses.size())];
  const double turn = turnTo(plane, view, choices);
  const Vec3 elevation = cross(view.axial, view.lateral);
  const auto pose =
      patientFromProbe(view.position_mm + view.lateral * choices.between(-4, 4) + elevation * choices.between(-8, 8),
                       view.axial, view.lateral * std::cos(turn) + elevation * std::sin(turn));
  if (!pose) return tl::unexpected(pose.error());
  return Turned{&view, *pose, turn};
}

/// True if tissue lies below both ends of a linear face, or below the middle half of a fan, whose outer scanlines pass
/// a round neck. There is no tissue outside the volume.
bool isOnTheBody(const PatientCase& patient, const ImagingSetup& setup, const Transform& patientFromProbe) {
  const bool isLinear = setup.probe.shape == ProbeShape::Linear;
  const double below_mm = isLinear ? 4 : 10, outer = isLinear ? 0 : 0.25;
  const BeamGrid grid(setup.probe, setup.settings);
  const Transform index = patient.labels.geometry.indexFromPatient();
  return std::ranges::all_of(std::array{outer, 1 - outer}, [&](double share) {
    const double line = share * (grid.scanlines() - 1);
    const Vec3 below = grid.origin(line) + grid.direction(line) * below_mm;
    return sampleNearest(patient.labels, index * (patientFromProbe * below)) != kBackground;
  });
}

/// Poses of a clip's frames, around a pose: the hand is not quite still, and may sweep slowly.
std::vector<Transform> clipPath(const Transform& middle, bool sweeps, Choices& choices) {
  const double sign = choices.happens(0.5) ? 1 : -1;
  const double slide_mmPerS = sweeps ? sign * choices.between(2, kFastestSlide_mmPerS) : 0;
  const double tilt_degPerS = sweeps ? choices.between(-kFastestTilt_degPerS, kFastestTilt_degPerS) : 0;
  const double phaseX = choices.between(0, 2 * std::numbers::pi), phaseY = choices.between(0, 2 * std::numbers::pi);
  std::vector<Transform> path;
  for (int frame = 0; frame < kClipFrames; ++frame) {
    const double t_s = double(frame - kClipFrames / 2) / kClipFrames_perSecond;
    const double turn = 2 * std::numbers::pi * kTremor_perS * t_s, tilt = tilt_degPerS * t_s * kDegree;
    const double x_mm = kTremor_mm * (std::sin(turn + phaseX) - std::sin(phaseX));
    const double y_mm = kTremor_mm * (std::sin(0.8 * turn + phaseY) - std::sin(phaseY)) + slide_mmPerS * t_s;
    const double c = std::cos(tilt), s = std::sin(tilt);
    path.push_back(middle * Transform{{{Vec3{1, 0, 0}, Vec3{0, c, s}, Vec3{0, -s, c}}}, {x_mm, y_mm, 0}});
  }
  return path;
}

std::string aboutOf(const ImagePlan& plan, const ImageKind& kind, const Machine& machine, const Turned& place) {
  const ImagingSettings& settings = plan.setup.settings;
  const char* const motion = !kind.clip ? "" : kind.sweeps ? ", clip, sweeping" : ", clip, held still";
  char text[240];
  std::snprintf(text, sizeof text,
                "%s, %s, turned %.0f degrees, %.1f N, %.0f mm, %.1f MHz, median %.0f, range %.0f dB, map %s%s",
                machine.name.c_str(), place.view->name.c_str(), place.turn_rad / kDegree, plan.force_N,
                settings.depth_mm, settings.frequency_MHz, plan.medianGray, settings.dynamicRange_dB,
                std::string(curveOf(settings.grayMap).name).c_str(), motion);
  return text;
}

}  // namespace

ScanPlane planeOf(const StartPose& view) {
  const double along = std::abs(view.lateral.z);
  return along < 0.5 ? ScanPlane::Transverse : along > 0.866 ? ScanPlane::Longitudinal : ScanPlane::Oblique;
}

Result<ImagePlan> planImage(const PatientCase& patient, std::span<const StartPose> views, const Probe& probe,
                            const AcousticTable& tissues, const ImageKind& kind, Choices& choices) {
  constexpr int kTries = 40;
  constexpr double kTransverse = 0.45, kOblique = 0.15;
  const Machine& machine = machines()[choices.index(machines().size())];
  const auto own = settingsOf(machine.name, probe, settingsFor(probe));
  if (!own) return tl::unexpected(own.error());
  ImagePlan plan{.setup = {probe, chosenSettings(*own, probe, choices), tissues}, .patientFromProbe = {}, .about = {}};
  const double drawn = choices.between(0, 1);
  plan.plane = kind.plane.value_or(drawn < kTransverse    ? ScanPlane::Transverse
                                   : drawn < 1 - kOblique ? ScanPlane::Longitudinal
                                                          : ScanPlane::Oblique);
  for (int n = 0; n < kTries; ++n) {
    const auto place = turned(views, plan.plane, choices);
    if (!place) return tl::unexpected(place.error());
    plan.patientFromProbe =
        kind.clip ? clipPath(place->patientFromProbe, kind.sweeps, choices) : std::vector{place->patientFromProbe};
    if (!std::ranges::all_of(plan.patientFromProbe,
                             [&](const Transform& pose) { return isOnTheBody(patient, plan.setup, pose); }))
      continue;
    plan.force_N = choices.between(0, kLargestForce_N);
    plan.medianGray = kDarkest * std::pow(kBrightest / kDarkest, choices.between(0, 1));
    plan.start_s = choices.between(0, 4);
    plan.about = aboutOf(plan, kind, machine, *place);
    return plan;
  }
  return fail("The whole face of the probe \"" + probe.name + "\" finds no skin in " + std::string(nameOf(plan.plane)) +
              " planes near the start poses of " + patient.manifest.title +
              ". Leave this case out, or give it start poses farther from the ends of its volume.");
}

}  // namespace insonate::bench
