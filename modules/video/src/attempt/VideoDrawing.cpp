#include "attempt/VideoDrawing.h"

#include <insonate/procedure/MetricTitle.h>
#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/video/AttemptVideo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

namespace insonate::video {
namespace {

/// Colors of the window (views/Theme.h, ui/StateColors.h).
constexpr Ink kGround{0x14, 0x17, 0x1a}, kPanel{0x1b, 0x1f, 0x24}, kLine{0x32, 0x3a, 0x43}, kText{0xd9, 0xdf, 0xe5},
    kQuiet{0xb0, 0xba, 0xc3}, kAccent{0x4a, 0xa3, 0xd8}, kGood{0x4c, 0xaf, 0x7d}, kCaution{0xe0, 0xa3, 0x3a},
    kDanger{0xe0, 0x5a, 0x52};

constexpr double kWidth = kAttemptVideoWidth_px, kHeight = kAttemptVideoHeight_px, kStrip = 488, kCaption = 34,
                 kMargin = 14;
constexpr Box kImageRoom{56, 30, kWidth - 56 - kMargin, kStrip - 30 - kCaption - 6};
constexpr std::int64_t kShown_us = 4'000'000;  ///< a milestone or error is shown so long

/// "1:05.3"
std::string clockOf(std::int64_t time_us) {
  const std::int64_t tenths = time_us / 100'000;
  char text[32];
  std::snprintf(text, sizeof text, "%d:%02d.%d", int(tenths / 600), int(tenths / 10 % 60), int(tenths % 10));
  return text;
}

std::string tenthsOf(double value) {
  const std::int64_t tenths = std::llround(std::abs(value) * 10);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
}

/// Side of the patient to which a direction points, LPS.
std::string sideOf(Vec3 direction) {
  const Vec3 size{std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)};
  if (size.z > size.x && size.z > size.y) return direction.z > 0 ? "Head" : "Foot";
  if (size.y > size.x) return direction.y > 0 ? "P" : "A";
  return direction.x > 0 ? "L" : "R";
}

/// Part of `box`, which contains the whole image, that shows the field of view; the rest of the image is black.
Box fieldOf(const LiveFrame& frame, const Box& box) {
  const BModeImage& image = frame.image;
  const BeamGrid grid(frame.setup->probe, frame.setup->settings);
  const double px_per_mm = box.height / (image.height * image.pixel_mm), left_mm = image.left_mm - image.pixel_mm / 2;
  const auto xOf = [&](double lateral_mm) {
    return std::clamp(box.left + (lateral_mm - left_mm) * px_per_mm, box.left, box.right());
  };
  const double left = xOf(grid.minLateral_mm());
  return {left, box.top, xOf(grid.maxLateral_mm()) - left, box.height};
}

/// Draws the depths left of `box`, which has the height of the image.
void drawDepthScale(const BModeImage& image, const Box& box, Canvas& canvas) {
  const double px_per_mm = box.height / (image.height * image.pixel_mm), top_mm = image.top_mm - image.pixel_mm / 2;
  const double numbered_mm = px_per_mm * 5 >= 34 ? 5 : px_per_mm * 10 >= 34 ? 10 : 20, step_mm = numbered_mm / 5;
  const double x = box.left - 8;
  for (int k = 0; k * step_mm <= top_mm + image.height * image.pixel_mm + 1e-9; ++k) {
    const double y = box.top + (k * step_mm - top_mm) * px_per_mm;
    const bool isNumbered = k % 5 == 0;
    canvas.line(x - (isNumbered ? 8 : 4), y, x, y, 1, isNumbered ? kText : kQuiet);
    if (isNumbered)
      canvas.text(x - 11, y + 5, std::to_string(int(k * step_mm)),
                  {.size_px = 14, .ink = kText, .align = Align::Right});
  }
  canvas.text(x - 11, box.top - 10, "mm", {.size_px = 13, .ink = kQuiet, .align = Align::Right});
}

/// Width of the letters for the sides of the patient and of the probe's marker; least width of the text between them.
constexpr double kSides_px = 110, kNarrowest_px = 40;

void drawImage(const VideoMoment& moment, Canvas& canvas) {
  if (!moment.image) {
    canvas.text(kWidth / 2, kStrip / 2, "No image: the probe is not held.",
                {.size_px = 20, .ink = kQuiet, .align = Align::Center});
    return;
  }
  const BModeImage& image = moment.image->image;
  const double scale = std::min(kImageRoom.width / image.width, kImageRoom.height / image.height);
  Box box{0, kImageRoom.top, image.width * scale, image.height * scale};
  box.left = kImageRoom.left + (kImageRoom.width - box.width) / 2;
  canvas.image(image, moment.image->color, box);
  const Box field = fieldOf(*moment.image, box);
  drawDepthScale(image, field, canvas);
  // The probe's marker is on the right, as in the window.
  const Vec3 lateral = moment.image->patientFromProbe.linear.column[0];
  canvas.disc(field.right() - 7, field.top - 13, 5.5, kAccent);
  canvas.text(field.right() - 18, field.top - 8, sideOf(lateral), {.size_px = 15, .ink = kText, .align = Align::Right});
  canvas.text(field.left, field.top - 8, sideOf(-lateral), {.size_px = 15, .ink = kText});
  const auto& sample = moment.replay.sample();
  if (sample && !(sample->imageDepth_mm > 0))
    canvas.text(field.left + field.width / 2, field.top - 8, "FROZEN",
                {.size_px = 16, .ink = kCaution, .isBold = true, .align = Align::Center},
                std::max(kNarrowest_px, field.width - kSides_px));
}

/// The last milestone or error, for some seconds.
void drawCaption(const VideoMoment& moment, Canvas& canvas) {
  const AttemptMoment* last = nullptr;
  for (const AttemptMoment& one : moment.moments)
    if (one.time_us <= moment.time_us && one.time_us > moment.time_us - kShown_us) last = &one;
  if (!last) return;
  canvas.fill({0, kStrip - kCaption, kWidth, kCaption}, kGround);
  const Ink ink = !last->severity ? kText : *last->severity == Severity::Critical ? kDanger : kCaution;
  canvas.text(kMargin, kStrip - 11, (last->severity ? "\u26a0 " : "") + last->description, {.size_px = 18, .ink = ink},
              kWidth - 2 * kMargin);
}

Ink inkOf(NeedlePlace place) {
  switch (place) {
    case NeedlePlace::Vein:
      return kGood;
    case NeedlePlace::WrongPlace:
      return kDanger;
    case NeedlePlace::Used:
      return kCaution;
    default:
      return kText;
  }
}

Ink inkOf(SyringeContent content) {
  switch (content) {
    case SyringeContent::DarkBlood:
      return {0xd0, 0x6a, 0x6a};
    case SyringeContent::BrightBlood:
      return {0xff, 0x5a, 0x5a};
    default:
      return kText;
  }
}

void drawState(const VideoMoment& moment, Canvas& canvas) {
  const ProcedureRun& run = moment.replay.run();
  const auto& sample = moment.replay.sample();
  const TextStyle quiet{.size_px = 18, .ink = kQuiet};
  const double clock =
      canvas.text(kMargin, kStrip + 28, clockOf(moment.time_us), {.size_px = 21, .ink = kText, .isBold = true});
  canvas.text(kMargin + clock + 8, kStrip + 28, "of " + clockOf(moment.end_us), quiet);
  const auto due = run.nextStep();
  const std::string step = due ? "Step: " + run.procedure().steps[*due].title : "All steps are done";
  if (!run.procedure().steps.empty())
    canvas.text(kWidth - kMargin, kStrip + 28, step, {.size_px = 18, .ink = kText, .align = Align::Right}, 430);
  const NeedlePlace place = run.metrics().needle();
  std::string needle = std::string(needleSymbol(place)) + " " + displayText(place, run.vesselAtTip());
  if (sample && sample->needleDepth_mm) needle += ", inserted " + tenthsOf(*sample->needleDepth_mm) + " mm";
  canvas.text(kMargin, kStrip + 56, needle, {.size_px = 18, .ink = inkOf(place), .isBold = true}, 560);
  const std::string force = "Probe " + tenthsOf(sample ? sample->probeForce_N : 0) + " N";
  canvas.text(kWidth - kMargin, kStrip + 56, force, {.size_px = 18, .ink = kText, .align = Align::Right});
  const SyringeContent content = moment.replay.syringe();
  canvas.text(kMargin, kStrip + 82, "Syringe: " + std::string(displayText(content, sample && sample->aspirating)),
              {.size_px = 18, .ink = inkOf(content)});
}

constexpr std::size_t kColumns = 2, kRows = 6;

/// The metrics with published values first, as in the window.
std::array<Metric, kColumns * kRows> shownMetrics(const Procedure& procedure) {
  std::vector<Metric> order;
  for (const MetricDefinition& one : metricTable()) order.push_back(one.metric);
  std::stable_partition(order.begin(), order.end(),
                        [&](Metric one) { return std::ranges::count(procedure.norms, one, &MetricNorm::metric) > 0; });
  std::array<Metric, kColumns * kRows> shown{};
  std::copy_n(order.begin(), shown.size(), shown.begin());
  return shown;
}

void drawMetrics(const VideoMoment& moment, Canvas& canvas) {
  const ProcedureRun& run = moment.replay.run();
  const MetricValues values = run.metrics().values();
  const double top = kStrip + 92, room = (kWidth - 2 * kMargin + 24) / kColumns, width = room - 24;
  canvas.line(kMargin, top, kWidth - kMargin, top, 1, kLine);
  const auto shown = shownMetrics(run.procedure());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const double left = kMargin + double(i / kRows) * room, y = top + 20 + double(i % kRows) * 22;
    const std::string value = metricText(shown[i], values[shown[i]]);
    const double used =
        canvas.text(left + width, y, value, {.size_px = 16, .ink = kText, .isBold = true, .align = Align::Right});
    canvas.text(left, y, std::string(metricTitle(shown[i])), {.size_px = 16, .ink = kQuiet}, width - used - 8);
  }
}

}  // namespace

void drawMoment(const VideoMoment& moment, Canvas& canvas) {
  canvas.fill({0, 0, kWidth, kHeight}, {0, 0, 0});
  canvas.fill({0, kStrip, kWidth, kHeight - kStrip}, kPanel);
  drawImage(moment, canvas);
  drawCaption(moment, canvas);
  drawState(moment, canvas);
  drawMetrics(moment, canvas);
}

}  // namespace insonate::video
