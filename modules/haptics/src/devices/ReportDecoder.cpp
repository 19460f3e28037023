#include <insonate/haptics/ReportDecoder.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

void putBits(std::span<std::uint8_t> bytes, int bit, int bits, std::uint32_t value) noexcept {
  for (int i = 0; i < bits; ++i) {
    const std::size_t byte = static_cast<std::size_t>(bit + i) / 8;
    const auto mask = static_cast<std::uint8_t>(1U << ((bit + i) % 8));
    if ((value >> i) & 1U)
      bytes[byte] |= mask;
    else
      bytes[byte] &= static_cast<std::uint8_t>(~mask);
  }
}

double outputOf(const ReportField& field, const DeviceOutput& output) noexcept {
  switch (field.quantity) {
    case Quantity::kForce:
      return output.force_N[field.index];
    case Quantity::kTorque:
      return output.torque_Nmm[field.index];
    case Quantity::kCurrent:
      return output.current_mA[static_cast<std::size_t>(field.index)];
    case Quantity::kSequence:
      return output.sequence & ((1ULL << field.bits) - 1);
    default:
      return 0;
  }
}

/// The range of forces is symmetric: the most negative number of two's complement is not used.
std::uint32_t countsOf(const ReportField& field, double value) noexcept {
  const double counts = value / field.scale;
  if (!std::isfinite(counts)) return 0;
  const double most = std::exp2(field.isSigned ? field.bits - 1 : field.bits) - 1;
  const double held = std::clamp(std::nearbyint(counts), field.isSigned ? -most : 0, most);
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(held));
}

}  // namespace

std::uint32_t bitsAt(std::span<const std::uint8_t> bytes, int bit, int bits) noexcept {
  std::uint32_t value = 0;
  for (int i = 0; i < bits; ++i) {
    const std::size_t byte = static_cast<std::size_t>(bit + i) / 8;
    if (byte >= bytes.size()) break;
    value |= static_cast<std::uint32_t>((bytes[byte] >> ((bit + i) % 8)) & 1U) << i;
  }
  return value;
}

std::int32_t signedValue(std::uint32_t raw, int bits) noexcept {
  const int unused = 32 - bits;
  return static_cast<std::int32_t>(raw << unused) >> unused;
}

ReportDecoder::ReportDecoder(const DeviceTable& table)
    : table_(table),
      numbered_(std::any_of(table.input.begin(), table.input.end(), [](const ReportLayout& r) { return r.id != 0; })) {}

void ReportDecoder::reset() noexcept {
  reading_ = {};
  counters_ = {};
}

const ReportLayout* ReportDecoder::layoutOf(int id, std::size_t bytes, ReportOutcome& fate) const noexcept {
  const ReportLayout* best = nullptr;
  fate = ReportOutcome::kUnknown;
  for (const ReportLayout& layout : table_.input) {
    if (layout.id != id) continue;
    const auto wanted = static_cast<std::size_t>(layout.bytes);
    if (bytes < wanted || (layout.exact && bytes > wanted)) {
      if (!best) fate = bytes < wanted ? ReportOutcome::kShort : ReportOutcome::kLong;
    } else if (!best || layout.bytes > best->bytes) {
      best = &layout;
      fate = ReportOutcome::kDecoded;
    }
  }
  return best;
}

ReportOutcome ReportDecoder::decode(std::span<const std::uint8_t> report) noexcept {
  if (report.empty()) return ReportOutcome::kUnknown;
  ReportOutcome fate{};
  const ReportLayout* layout = nullptr;
  std::span<const std::uint8_t> payload = report;
  if (numbered_) {
    payload = report.subspan(1);
    layout = layoutOf(report[0], payload.size(), fate);
  }
  // A table may contain both forms of a device, with and without ids.
  if (!layout) {
    ReportOutcome plain{};
    layout = layoutOf(0, report.size(), plain);
    if (!numbered_ || layout) fate = plain;
    if (layout) payload = report;
  }
  if (!layout) return fate;
  for (const ReportField& field : layout->fields) apply(field, payload);
  return fate;
}

double ReportDecoder::valueOf(const ReportField& field, std::uint32_t raw) noexcept {
  if (!field.wraps) return field.isSigned ? signedValue(raw, field.bits) : static_cast<double>(raw);
  Counter& counter = counters_[static_cast<std::size_t>(field.index)];
  // A counter moves by less than half its range from one report to the next.
  if (counter.known) counter.way += signedValue(raw - counter.last, field.bits);
  counter.known = true;
  counter.last = raw;
  return static_cast<double>(counter.way);
}

void ReportDecoder::apply(const ReportField& field, std::span<const std::uint8_t> payload) noexcept {
  const std::uint32_t raw = bitsAt(payload, field.bit, field.bits);
  const auto index = static_cast<std::size_t>(field.index);
  switch (field.quantity) {
    case Quantity::kEncoder:
      reading_.encoder[index] = valueOf(field, raw) * field.scale;
      break;
    case Quantity::kPosition:
      if (!reading_.position_mm) reading_.position_mm = Vec3{};
      (*reading_.position_mm)[field.index] = valueOf(field, raw) * field.scale;
      break;
    case Quantity::kQuaternion:
      reading_.quaternion[index] = valueOf(field, raw) * field.scale;
      break;
    case Quantity::kDeflection:
      reading_.deflection[index] = std::clamp(valueOf(field, raw) * field.scale, -1.0, 1.0);
      break;
    case Quantity::kButtons: {
      const std::uint32_t mask = field.bits == 32 ? ~0U : ((1U << field.bits) - 1) << field.index;
      reading_.buttons = (reading_.buttons & ~mask) | (raw << field.index);
      break;
    }
    case Quantity::kKey: {
      bool pressed = false;
      for (int i = 0; i < field.count; ++i)
        pressed |= bitsAt(payload, field.bit + i * field.bits, field.bits) == static_cast<std::uint32_t>(field.usage);
      reading_.buttons =
          (reading_.buttons & ~(1U << field.index)) | (static_cast<std::uint32_t>(pressed) << field.index);
      break;
    }
    case Quantity::kStatus:
      reading_.status = raw;
      break;
    case Quantity::kSequence:
      reading_.sequence = raw;
      break;
    case Quantity::kTime:
      reading_.time_s = raw * field.scale;
      break;
    default:
      break;  // output fields have no value in an input report
  }
}

std::size_t encodeReport(const ReportLayout& layout, const DeviceOutput& output,
                         std::span<std::uint8_t> report) noexcept {
  const std::size_t size = static_cast<std::size_t>(layout.bytes) + 1;
  if (report.size() < size) return 0;
  std::fill_n(report.begin(), size, std::uint8_t{0});
  report[0] = static_cast<std::uint8_t>(layout.id);
  for (const ReportField& field : layout.fields)
    putBits(report.subspan(1), field.bit, field.bits, countsOf(field, outputOf(field, output)));
  return size;
}

}  // namespace insonate
