#include "record/SegmentCodec.h"

#include <algorithm>
#include <array>

namespace insonate::record {
namespace {

constexpr int kOrders = 3;
constexpr std::size_t kEventBytesOfFormat2 = 8 + 3 + 8 * 3 + 8 * 3 + 8 + 1 + 8 * 3 + 8;
constexpr std::size_t kEventBytesOfFormat4 = kEventBytesOfFormat2 + 1;  // includes the vessel
constexpr std::size_t kEventBytes = kEventBytesOfFormat4 + 1 + 1 + 8;   // includes act, instrument and amount
constexpr int kChannelsOfFormat1 = 21, kChannelsOfFormat4 = 22;         // without tenting; without the line
using Channel = std::vector<std::uint32_t>;

/// Differences of 32-bit numbers wrap around, and so do sums, so that no information is lost.
void difference(Channel& values) {
  for (std::size_t i = values.size(); i-- > 1;) values[i] -= values[i - 1];
}
void sum(Channel& values) {
  for (std::size_t i = 1; i < values.size(); ++i) values[i] += values[i - 1];
}

/// 0, -1, 1, -2, ... as 0, 1, 2, 3, ...
std::uint32_t folded(std::uint32_t value) {
  return (value << 1) ^ (0U - (value >> 31));
}
std::uint32_t unfolded(std::uint32_t value) {
  return (value >> 1) ^ (0U - (value & 1));
}

std::uint64_t bitsOf(const Channel& values) {
  std::uint64_t bits = 0;
  for (const std::uint32_t value : values) bits += std::bit_width(folded(value));
  return bits;
}

void putChannel(Bytes& bytes, Channel values) {
  Channel best = values;
  std::uint8_t order = 0;
  for (std::uint8_t tried = 1; tried < kOrders; ++tried) {
    difference(values);
    if (bitsOf(values) < bitsOf(best)) best = values, order = tried;
  }
  bytes.push_back(order);
  for (int plane = 0; plane < 4; ++plane)
    for (const std::uint32_t value : best) bytes.push_back(static_cast<std::uint8_t>(folded(value) >> (8 * plane)));
}

std::optional<Channel> getChannel(ByteReader& reader, std::size_t count) {
  const auto order = reader.get<std::uint8_t>();
  if (order >= kOrders) return std::nullopt;
  Channel values(count);
  for (int plane = 0; plane < 4; ++plane)
    for (std::uint32_t& value : values) value |= std::uint32_t{reader.get<std::uint8_t>()} << (8 * plane);
  for (std::uint32_t& value : values) value = unfolded(value);
  for (int i = 0; i < order; ++i) sum(values);
  return values;
}

void put(Bytes& bytes, Vec3 v) {
  for (int axis = 0; axis < 3; ++axis) record::put(bytes, v[axis]);
}
Vec3 getVec3(ByteReader& reader) {
  Vec3 v;
  for (int axis = 0; axis < 3; ++axis) v[axis] = reader.getDouble();
  return v;
}

void putEvent(Bytes& bytes, const AttemptEvent& event) {
  record::put(bytes, event.time_us);
  bytes.push_back(static_cast<std::uint8_t>(event.kind));
  bytes.push_back(event.wall), bytes.push_back(event.into);
  put(bytes, event.tip_mm), put(bytes, event.axis);
  record::put(bytes, event.depth_mm);
  bytes.push_back(event.outward.has_value());
  put(bytes, event.outward.value_or(Vec3{}));
  record::put(bytes, event.tilt_deg);
  bytes.push_back(event.vessel);
  bytes.push_back(static_cast<std::uint8_t>(event.act));
  bytes.push_back(static_cast<std::uint8_t>(event.instrument));
  record::put(bytes, event.amount);
}

std::optional<AttemptEvent> getEvent(ByteReader& reader, std::size_t eventBytes) {
  AttemptEvent event;
  event.time_us = reader.getTime();
  const auto kind = reader.get<std::uint8_t>(), wall = reader.get<std::uint8_t>(), into = reader.get<std::uint8_t>();
  if (kind >= kAttemptEventKinds || wall >= kLabelCount || into >= kLabelCount) return std::nullopt;
  event.kind = static_cast<AttemptEventKind>(kind);
  event.wall = static_cast<Label>(wall), event.into = static_cast<Label>(into);
  event.tip_mm = getVec3(reader), event.axis = getVec3(reader);
  event.depth_mm = reader.getDouble();
  const bool hasOutward = reader.get<std::uint8_t>() != 0;
  const Vec3 outward = getVec3(reader);
  if (hasOutward) event.outward = outward;
  event.tilt_deg = reader.getDouble();
  if (eventBytes >= kEventBytesOfFormat4) event.vessel = reader.get<std::uint8_t>();
  if (eventBytes < kEventBytes) return event;
  const auto act = reader.get<std::uint8_t>(), instrument = reader.get<std::uint8_t>();
  if (act >= kLineActs || instrument >= kInstruments) return std::nullopt;
  event.act = static_cast<LineAct>(act), event.instrument = static_cast<Instrument>(instrument);
  event.amount = reader.getDouble();
  return event;
}

}  // namespace

Bytes encoded(const RecordingSegment& segment) {
  const std::size_t count = segment.samples.size();
  Bytes bytes;
  bytes.reserve(64 + count * 4 * (QuantizedSample::kChannels + 1) + segment.events.size() * (kEventBytes + 4));
  record::put(bytes, static_cast<std::uint32_t>(count));
  record::put(bytes, static_cast<std::uint32_t>(segment.events.size()));
  record::put(bytes, segment.samplesLost);
  const std::int64_t first_us = count ? segment.samples.front().time_us : 0;
  record::put(bytes, first_us);
  Channel values(count);
  std::ranges::transform(segment.samples, values.begin(), [&](const QuantizedSample& sample) {
    return static_cast<std::uint32_t>(sample.time_us - first_us);
  });
  putChannel(bytes, values);
  for (int c = 0; c < QuantizedSample::kChannels; ++c) {
    std::ranges::transform(segment.samples, values.begin(), [&](const QuantizedSample& sample) {
      return static_cast<std::uint32_t>(sample.channel[c]);
    });
    putChannel(bytes, values);
  }
  for (const RecordingSegment::PlacedEvent& happened : segment.events) {
    record::put(bytes, happened.afterSamples);
    putEvent(bytes, happened.event);
  }
  return bytes;
}

std::optional<RecordingSegment> decoded(std::span<const std::uint8_t> bytes) {
  ByteReader reader(bytes);
  const auto count = reader.get<std::uint32_t>(), events = reader.get<std::uint32_t>();
  RecordingSegment segment;
  segment.samplesLost = reader.get<std::uint32_t>();
  const std::int64_t first_us = reader.getTime();
  // The length determines the format.
  const auto fits = [&](int channels, std::uint64_t eventBytes) {
    return reader.left() == (channels + std::uint64_t{1}) * (1 + 4 * std::uint64_t{count}) + events * (eventBytes + 4);
  };
  struct Layout {
    int channels;
    std::size_t eventBytes;
  };
  constexpr std::array kLayouts{
      Layout{QuantizedSample::kChannels, kEventBytes}, Layout{kChannelsOfFormat4, kEventBytesOfFormat4},
      Layout{kChannelsOfFormat4, kEventBytesOfFormat2}, Layout{kChannelsOfFormat1, kEventBytesOfFormat2}};
  const auto layout = std::ranges::find_if(kLayouts, [&](const Layout& l) { return fits(l.channels, l.eventBytes); });
  if (layout == kLayouts.end()) return std::nullopt;
  segment.samples.resize(count);
  for (int c = -1; c < layout->channels; ++c) {
    const auto values = getChannel(reader, count);
    if (!values) return std::nullopt;
    for (std::size_t i = 0; i < count; ++i) {
      if (c < 0)
        segment.samples[i].time_us = first_us + (*values)[i];
      else
        segment.samples[i].channel[c] = static_cast<std::int32_t>((*values)[i]);
    }
  }
  for (std::uint32_t i = 0; i < events; ++i) {
    const auto after = reader.get<std::uint32_t>();
    const auto event = getEvent(reader, layout->eventBytes);
    if (!event || after > count) return std::nullopt;
    segment.events.push_back({after, *event});
  }
  return segment;
}

}  // namespace insonate::record
