#include <insonate/igtlink/ImageLink.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace insonate {
namespace {

/// Patient space is LPS. A half turn about z: the transforms stay rigid.
const Transform kRasFromLps{{{Vec3{-1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}}}, {}};

/// Maps (column, row, 0) to the probe frame. The third direction makes the frame right-handed, as in PLUS.
Transform probeFromPixel(const BModeImage& image) {
  const double step = image.pixel_mm;
  return {{{Vec3{step, 0, 0}, Vec3{0, 0, step}, Vec3{0, -step, 0}}}, {image.left_mm, 0, image.top_mm}};
}

Transform patientFromNeedle(const Needle& needle) {
  const Vec3 z = needle.direction;
  const Vec3 y = -normalized(needle.bevelNormal - dot(needle.bevelNormal, z) * z);
  return {{{cross(y, z), y, z}}, needle.tip_mm};
}

/// A setting that is a number.
struct LinkedNumber {
  std::string_view name, alias;  ///< name in PLUS, and in the examples of its manual
  double ImagingSettings::*member;
  double scale = 1, offset = 0;  ///< value in the command = offset + scale * setting
};
constexpr std::array kNumbers{
    LinkedNumber{"DepthMm", "Depth", &ImagingSettings::depth_mm},
    LinkedNumber{"FrequencyMhz", "Frequency", &ImagingSettings::frequency_MHz},
    LinkedNumber{"FocusMm", "Focus", &ImagingSettings::focus_mm},
    LinkedNumber{"GainPercent", "", &ImagingSettings::gain_dB, 1.25, 50},
    LinkedNumber{"GainDb", "Gain", &ImagingSettings::gain_dB},
    LinkedNumber{"DynRangeDb", "DynRange", &ImagingSettings::dynamicRange_dB},
};
constexpr std::string_view kFreeze = "Freeze", kTrue = "TRUE", kFalse = "FALSE";

std::string textOfNumber(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6).ptr;
  return {text.data(), end};
}

std::optional<double> numberOf(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string unknownParameter(const std::string& name) {
  std::string known;
  for (const LinkedNumber& number : kNumbers) known += std::string(number.name) + ", ";
  return "There is no parameter '" + name + "'. Known are " + known + std::string(kFreeze) + ".";
}

/// Sets (`isSet`) or reads one parameter. Fails with a sentence.
Result<void> performParameter(LinkParameter& parameter, bool isSet, const Probe& probe, LinkedSettings& all) {
  if (parameter.name == kFreeze) {
    if (isSet) {
      if (parameter.value != kTrue && parameter.value != kFalse) return fail("Freeze is TRUE or FALSE.");
      all.frozen = parameter.value == kTrue;
    }
    parameter.value = all.frozen ? kTrue : kFalse;
    return {};
  }
  const auto number = std::ranges::find_if(kNumbers, [&](const LinkedNumber& known) {
    return known.name == parameter.name || (!known.alias.empty() && known.alias == parameter.name);
  });
  if (number == kNumbers.end()) return fail(unknownParameter(parameter.name));
  Result<void> done;
  if (isSet) {
    const auto value = numberOf(parameter.value);
    if (!value) return fail("The value '" + parameter.value + "' of " + parameter.name + " is not a number.");
    ImagingSettings changed = all.settings;
    changed.*(number->member) = (*value - number->offset) / number->scale;
    done = validate(changed, probe);
    if (done) all.settings = changed;
  }
  parameter.value = textOfNumber(number->offset + number->scale * (all.settings.*(number->member)));
  return done;
}

}  // namespace

std::shared_ptr<const LinkFrame> linkFrameOf(std::shared_ptr<const LiveFrame> image) {
  const Transform referenceFromPixel = kRasFromLps * image->patientFromProbe * probeFromPixel(image->image);
  auto frame = std::make_shared<LinkFrame>();
  frame->transforms = {{"ProbeToReference", kRasFromLps * image->patientFromProbe},
                       {"ImageToReference", referenceFromPixel}};
  if (image->needle) {
    const Transform referenceFromNeedle = kRasFromLps * patientFromNeedle(*image->needle);
    for (const char* name : {"NeedleToReference", "StylusTipToReference"})
      frame->transforms.push_back({name, referenceFromNeedle});
  }
  frame->time_ns =
      std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch()).count();
  const std::vector<std::uint8_t>* gray = &image->image.gray;
  const int width = image->image.width, height = image->image.height;
  frame->image = {"Image_Reference", width, height, referenceFromPixel, {std::move(image), gray}};
  return frame;
}

LinkReply performCommand(const LinkCommand& command, const Probe& probe, LinkedSettings& settings) {
  const bool isSet = command.name == "SetUsParameter";
  if (!isSet && command.name != "GetUsParameter")
    return {false, "There is no command '" + command.name + "'. Known are SetUsParameter and GetUsParameter.", {}};
  if (command.parameters.empty()) return {false, "The command names no Parameter.", {}};
  LinkReply reply{true, {}, command.parameters};
  for (LinkParameter& parameter : reply.parameters) {
    const auto done = performParameter(parameter, isSet, probe, settings);
    parameter.success = done.has_value();
    reply.success &= parameter.success;
    reply.sentence += (reply.sentence.empty() ? "" : " ") +
                      (done ? parameter.name + " is " + parameter.value + "." : done.error().message);
  }
  return reply;
}

}  // namespace insonate
