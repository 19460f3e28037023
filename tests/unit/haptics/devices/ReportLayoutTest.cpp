#include "Reports.h"

#include <insonate/haptics/ReportDecoder.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

using namespace insonate;

namespace {

using test::Bytes;

const DeviceTable& tableOf(const std::string& name) {
  for (const DeviceTable& table : builtInDeviceTables())
    if (table.name.starts_with(name)) return table;
  throw std::runtime_error("no table " + name);
}

/// Least significant byte first.
void append(Bytes& bytes, std::int64_t value, int size) {
  for (int i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

Bytes words(std::initializer_list<int> values, Bytes start = {}) {
  for (const int v : values) append(start, v, 2);
  return start;
}

TEST(ReportBits, AreCountedFromTheLowestAndMayCrossBytes) {
  const Bytes bytes{0b1010'0101, 0b0000'1111};
  EXPECT_EQ(bitsAt(bytes, 0, 8), 0xA5U);
  EXPECT_EQ(bitsAt(bytes, 4, 8), 0xFAU);
  EXPECT_EQ(bitsAt(bytes, 12, 8), 0U);  // beyond the end
  EXPECT_EQ(signedValue(0x8000, 16), -32768);
  EXPECT_EQ(signedValue(0xFFFF, 16), -1);
  EXPECT_EQ(signedValue(0x7FFF, 16), 32767);
  EXPECT_EQ(signedValue(0x10001, 16), 1);
  EXPECT_EQ(signedValue(0xFFFFFFFF, 32), -1);
}

TEST(WoodenHapticsReports, SixEncodersLowByteFirstWithSign) {
  ReportDecoder decoder(tableOf("WoodenHaptics"));
  EXPECT_EQ(decoder.decode(words({0, 0, 0, 0, 0, 0, 0})), ReportOutcome::kDecoded);
  EXPECT_EQ(decoder.decode(words({1, -2, 0x1234, -300, 5, 6, 7})), ReportOutcome::kDecoded);
  const auto& encoder = decoder.reading().encoder;
  EXPECT_EQ(encoder, (std::array<double, 6>{1, -2, 0x1234, -300, 5, 6}));
  EXPECT_EQ(decoder.reading().status, 7U);
}

TEST(WoodenHapticsReports, CountsRunOverTheEndOfSixteenBits) {
  ReportDecoder decoder(tableOf("WoodenHaptics"));
  std::int64_t count = 32000;
  decoder.decode(words({static_cast<std::int16_t>(count), 0, 0, 0, 0, 0, 0}));
  for (int i = 0; i < 40; ++i) {
    count += 30000;
    decoder.decode(words({static_cast<std::int16_t>(count), 0, 0, 0, 0, 0, 0}));
  }
  EXPECT_EQ(decoder.reading().encoder[0], 40 * 30000.0);
  for (int i = 0; i < 80; ++i) {
    count -= 30000;
    decoder.decode(words({static_cast<std::int16_t>(count), 0, 0, 0, 0, 0, 0}));
  }
  EXPECT_EQ(decoder.reading().encoder[0], -40 * 30000.0);
  decoder.reset();
  decoder.decode(words({-5, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(decoder.reading().encoder[0], 0);
}

TEST(WoodenHapticsReports, ShortOnesChangeNothingAndPaddingIsIgnored) {
  ReportDecoder decoder(tableOf("WoodenHaptics"));
  decoder.decode(words({0, 0, 0, 0, 0, 0, 0}));
  Bytes report = words({10, 0, 0, 0, 0, 0, 0});
  report.pop_back();
  EXPECT_EQ(decoder.decode(report), ReportOutcome::kShort);
  EXPECT_EQ(decoder.decode({}), ReportOutcome::kUnknown);
  EXPECT_EQ(decoder.reading().encoder[0], 0);
  // A raw HID endpoint fills its packets up to 64 bytes.
  report = words({10, 0, 0, 0, 0, 0, 0});
  report.resize(64, 0xEE);
  EXPECT_EQ(decoder.decode(report), ReportOutcome::kDecoded);
  EXPECT_EQ(decoder.reading().encoder[0], 10);
}

TEST(WoodenHapticsReports, CurrentsGoOutWithSignRoundedAndHeld) {
  const ReportLayout& layout = *tableOf("WoodenHaptics").output;
  DeviceOutput output;
  output.current_mA = {-1500.4, 1e9, std::nan("")};
  std::array<std::uint8_t, 64> report;
  report.fill(0xEE);
  ASSERT_EQ(encodeReport(layout, output, report), 15U);
  EXPECT_EQ(report[0], 0);  // not numbered
  EXPECT_EQ(signedValue(bitsAt(std::span(report).subspan(1), 0, 16), 16), -1500);
  EXPECT_EQ(signedValue(bitsAt(std::span(report).subspan(1), 16, 16), 16), 32767);
  for (std::size_t i = 5; i < 15; ++i) EXPECT_EQ(report[i], 0) << i;  // no command either
  EXPECT_EQ(report[15], 0xEE);
  EXPECT_EQ(encodeReport(layout, output, std::span(report).first(14)), 0U);
  output.current_mA = {-1e9, 0, -std::numeric_limits<double>::infinity()};
  encodeReport(layout, output, report);
  EXPECT_EQ(signedValue(bitsAt(std::span(report).subspan(1), 0, 16), 16), -32767);
}

TEST(SpaceMouseReports, TranslationRotationAndButtonsComeInTheirOwn) {
  ReportDecoder decoder(tableOf("SpaceMouse"));
  // The cap to the right, to the user, down.
  EXPECT_EQ(decoder.decode(words({350, 175, 350}, {1})), ReportOutcome::kDecoded);
  EXPECT_EQ(decoder.decode(words({-175, 35, 700}, {2})), ReportOutcome::kDecoded);
  EXPECT_EQ(decoder.decode(Bytes{3, 0b10, 0}), ReportOutcome::kDecoded);
  const DeviceReading& r = decoder.reading();
  const std::array<double, 6> wanted{1, -1, 0.5, -0.5, -1, 0.1};  // right, up, to the user
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(r.deflection[i], wanted[i], 1e-9) << i;
  EXPECT_EQ(r.buttons, 2U);
  EXPECT_FALSE(r.position_mm);
}

TEST(SpaceMouseReports, NewerOnesTellAllSixAtOnce) {
  ReportDecoder decoder(tableOf("SpaceMouse"));
  EXPECT_EQ(decoder.decode(words({350, 0, 0, 35, 70, -105}, {1})), ReportOutcome::kDecoded);
  EXPECT_NEAR(decoder.reading().deflection[0], 1, 1e-9);
  EXPECT_NEAR(decoder.reading().deflection[3], 0.1, 1e-9);
  EXPECT_NEAR(decoder.reading().deflection[5], 0.2, 1e-9);
  EXPECT_NEAR(decoder.reading().deflection[4], 0.3, 1e-9);
  // 31 buttons in four bytes, or 15 in two.
  EXPECT_EQ(decoder.decode(Bytes{3, 0, 0, 0, 0x40}), ReportOutcome::kDecoded);
  EXPECT_EQ(decoder.reading().buttons, 0x40000000U);
  EXPECT_EQ(decoder.decode(Bytes{3, 1, 0}), ReportOutcome::kDecoded);
  EXPECT_EQ(decoder.reading().buttons & 0xFFFFU, 1U);
}

TEST(SpaceMouseReports, BatteryAndTruncatedReportsChangeNothing) {
  ReportDecoder decoder(tableOf("SpaceMouse"));
  decoder.decode(words({350, 0, 0}, {1}));
  EXPECT_EQ(decoder.decode(Bytes{0x17, 100}), ReportOutcome::kUnknown);
  EXPECT_EQ(decoder.decode(Bytes{1, 0, 0, 0, 0, 0}), ReportOutcome::kShort);
  EXPECT_EQ(decoder.decode(Bytes{1}), ReportOutcome::kShort);
  EXPECT_NEAR(decoder.reading().deflection[0], 1, 1e-9);
}

TEST(PedalReports, VecInfinity) {
  ReportDecoder decoder(tableOf("VEC"));
  for (const std::uint8_t pressed : {1, 2, 4, 7, 0}) {
    EXPECT_EQ(decoder.decode(Bytes{pressed, 0}), ReportOutcome::kDecoded);
    EXPECT_EQ(decoder.reading().buttons, pressed);
  }
  EXPECT_EQ(decoder.decode(Bytes{1}), ReportOutcome::kShort);
  EXPECT_EQ(decoder.reading().buttons, 0U);
}

TEST(PedalReports, XKeysLeavesTheFirstBitOfItsThirdByte) {
  ReportDecoder decoder(tableOf("X-keys"));
  Bytes report(35, 0xFF);
  for (const auto& [byte, buttons] :
       {std::pair{0x02, 1U}, {0x04, 2U}, {0x08, 4U}, {0x0E, 7U}, {0x01, 0U}, {0xF1, 0U}}) {
    report[2] = static_cast<std::uint8_t>(byte);
    EXPECT_EQ(decoder.decode(report), ReportOutcome::kDecoded);
    EXPECT_EQ(decoder.reading().buttons, buttons) << byte;
  }
}

TEST(PedalReports, KeyboardClassInAnyPlaceOfTheSix) {
  ReportDecoder decoder(tableOf("Keyboard"));
  EXPECT_EQ(decoder.decode(Bytes{0, 0, 4, 0, 0, 0, 0, 0}), ReportOutcome::kDecoded);
  EXPECT_EQ(decoder.reading().buttons, 1U);
  EXPECT_EQ(decoder.decode(Bytes{0, 0, 30, 6, 4, 0, 0, 0}), ReportOutcome::kDecoded);
  EXPECT_EQ(decoder.reading().buttons, 5U);
  EXPECT_EQ(decoder.decode(Bytes{0, 0, 0, 0, 0, 0, 0, 5}), ReportOutcome::kDecoded);
  EXPECT_EQ(decoder.reading().buttons, 2U);
  // With Ctrl held, the modifiers look like a report's id, and are none.
  EXPECT_EQ(decoder.decode(Bytes{1, 0, 4, 0, 0, 0, 0, 0}), ReportOutcome::kDecoded);
  EXPECT_EQ(decoder.reading().buttons, 1U);
  EXPECT_EQ(decoder.decode(Bytes{1, 0, 0, 5, 0, 0, 0, 0, 0}), ReportOutcome::kDecoded);  // numbered
  EXPECT_EQ(decoder.reading().buttons, 2U);
  EXPECT_NE(decoder.decode(Bytes{2, 0, 4}), ReportOutcome::kDecoded);
  EXPECT_NE(decoder.decode(Bytes{3, 0, 4, 0, 0, 0, 0, 0, 0}), ReportOutcome::kDecoded);
  EXPECT_EQ(decoder.reading().buttons, 2U);
}

Bytes insonateReport() {
  Bytes report{1};
  for (const int micrometres : {-12345, 70000, 1}) append(report, micrometres, 4);
  for (const int q : {32767, 0, -32767, 1}) append(report, q, 2);
  append(report, 0x8001, 2);
  append(report, 3, 2);
  append(report, 65535, 2);
  append(report, 4000000000LL, 4);
  return report;
}

TEST(InsonateReports, PoseButtonsStatusSequenceAndTime) {
  ReportDecoder decoder(tableOf("Insonate"));
  ASSERT_EQ(decoder.decode(insonateReport()), ReportOutcome::kDecoded);
  const DeviceReading& r = decoder.reading();
  ASSERT_TRUE(r.position_mm);
  EXPECT_NEAR(r.position_mm->x, -12.345, 1e-9);
  EXPECT_NEAR(r.position_mm->y, 70, 1e-9);
  EXPECT_NEAR(r.position_mm->z, 0.001, 1e-9);
  EXPECT_NEAR(r.quaternion[0], 1, 1e-9);
  EXPECT_NEAR(r.quaternion[2], -1, 1e-9);
  EXPECT_EQ(r.buttons, 0x8001U);
  EXPECT_EQ(r.status, 3U);
  EXPECT_EQ(r.sequence, 65535U);
  EXPECT_NEAR(r.time_s, 4000, 1e-9);
}

TEST(InsonateReports, AnotherLengthIsAnotherFirmware) {
  ReportDecoder decoder(tableOf("Insonate"));
  Bytes report = insonateReport();
  report.push_back(0);
  EXPECT_EQ(decoder.decode(report), ReportOutcome::kLong);
  report.resize(30);
  EXPECT_EQ(decoder.decode(report), ReportOutcome::kShort);
  report[0] = 9;
  EXPECT_EQ(decoder.decode(report), ReportOutcome::kUnknown);
  EXPECT_FALSE(decoder.reading().position_mm);
}

TEST(InsonateReports, ForceAndTorqueInCounts) {
  DeviceOutput output{{1.5, -3.3, 0.0004}, {100, -0.1, 0}, {}, 0x12345};
  std::array<std::uint8_t, 64> report{};
  ASSERT_EQ(encodeReport(*tableOf("Insonate").output, output, report), 15U);
  EXPECT_EQ(report[0], 2);
  const auto payload = std::span<const std::uint8_t>(report).subspan(1);
  const std::array<int, 6> counts{1500, -3300, 0, 1000, -1, 0};
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(signedValue(bitsAt(payload, static_cast<int>(16 * i), 16), 16), counts[i]) << i;
  EXPECT_EQ(bitsAt(payload, 96, 16), 0x2345U);
}

TEST(ReportDecoder, TakesAnyBytesWithoutHarm) {
  std::mt19937 random(7);
  for (const DeviceTable& table : builtInDeviceTables()) {
    ReportDecoder decoder(table);
    for (int i = 0; i < 20000; ++i) {
      Bytes report(random() % 70);
      for (auto& b : report) b = static_cast<std::uint8_t>(random());
      decoder.decode(report);
      for (const double d : decoder.reading().deflection) ASSERT_LE(std::abs(d), 1);
      for (const double e : decoder.reading().encoder) ASSERT_TRUE(std::isfinite(e));
    }
  }
}

}  // namespace
