#include <insonate/igtlink/ImageLink.h>
#include <insonate/simulator/ProbePose.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

/// An image of an oblique probe, and a needle.
std::shared_ptr<LiveFrame> obliqueImage() {
  auto image = std::make_shared<LiveFrame>();
  image->image = {820, 616, 0.065, -26.6175, -0.3, std::vector<std::uint8_t>(820 * 616, 40)};
  image->patientFromProbe = patientFromProbe({-31, 62.5, 1403.25}, {0.3, -0.8, 0.2}, {0.9, 0.4, 0.1}).value();
  return image;
}

Vec3 rasOf(Vec3 lps) {
  return {-lps.x, -lps.y, lps.z};
}

/// Pixel to Reference by the matrix in the bytes of an IMAGE message, as the protocol describes it.
Vec3 placeByMessage(const std::vector<std::uint8_t>& message, double column, double row) {
  const auto real = [&](std::size_t index) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 4; ++i) bits = (bits << 8) | message.at(58 + 12 + 4 * index + i);
    return double{std::bit_cast<float>(bits)};
  };
  const auto vector = [&](std::size_t index) { return Vec3{real(index), real(index + 1), real(index + 2)}; };
  const auto size = [&](std::size_t axis) { return message.at(64 + 2 * axis) * 256 + message.at(65 + 2 * axis); };
  return vector(9) + vector(0) * (column - (size(0) - 1) / 2.0) + vector(3) * (row - (size(1) - 1) / 2.0);
}

TEST(ImageLink, PixelsAreWhereTheImageShowsThem) {
  const auto image = obliqueImage();
  const auto frame = linkFrameOf(image);
  EXPECT_EQ(frame->image.gray.get(), &image->image.gray);
  std::vector<std::uint8_t> message;
  appendImage(message, frame->image, frame->time_ns);
  ASSERT_EQ(message.size(), 58U + 72 + 820 * 616);
  const BModeImage& shown = image->image;
  for (const auto& [column, row] : {std::pair{0, 0}, {819, 0}, {0, 615}, {819, 615}, {400, 17}}) {
    const Vec3 point_probe{shown.left_mm + column * shown.pixel_mm, 0, shown.top_mm + row * shown.pixel_mm};
    const Vec3 place = rasOf(image->patientFromProbe * point_probe);
    EXPECT_LT(norm(placeByMessage(message, column, row) - place), 1e-3);
    EXPECT_EQ(frame->transforms.at(1).name, "ImageToReference");
    EXPECT_LT(norm(frame->transforms[1].targetFromSource * Vec3{double(column), double(row), 0} - place), 1e-9);
  }
  const Mat3& axes = frame->image.referenceFromPixel.linear;
  EXPECT_NEAR(determinant(axes), std::pow(shown.pixel_mm, 3), 1e-12) << "right-handed";
}

TEST(ImageLink, TransformsHaveTheNamesOfPlus) {
  const auto image = obliqueImage();
  EXPECT_EQ(linkFrameOf(image)->transforms.size(), 2U);
  image->needle = Needle{.tip_mm = {-20, 55, 1400}, .direction = normalized({1, 2, 3}), .bevelNormal = {0, 0, 1}};
  const auto frame = linkFrameOf(image);
  ASSERT_EQ(frame->transforms.size(), 4U);
  const LinkTransform &probe = frame->transforms[0], &needle = frame->transforms[2], &stylus = frame->transforms[3];
  EXPECT_EQ(probe.name, "ProbeToReference");
  EXPECT_LT(norm(probe.targetFromSource * Vec3{1, 2, 3} - rasOf(image->patientFromProbe * Vec3{1, 2, 3})), 1e-9);
  EXPECT_EQ(needle.name, "NeedleToReference");
  EXPECT_EQ(stylus.name, "StylusTipToReference");
  EXPECT_EQ(needle.targetFromSource, stylus.targetFromSource);
  EXPECT_LT(norm(needle.targetFromSource.offset - rasOf(image->needle->tip_mm)), 1e-9);
  EXPECT_LT(norm(needle.targetFromSource.linear.column[2] - rasOf(image->needle->direction)), 1e-9);
  EXPECT_LT(dot(needle.targetFromSource.linear.column[1], rasOf(image->needle->bevelNormal)), 0);
  EXPECT_NEAR(determinant(needle.targetFromSource.linear), 1, 1e-9);
}

LinkReply performed(const std::string& text, LinkedSettings& settings) {
  const auto command = parsedCommand(text);
  EXPECT_TRUE(command) << text;
  const Probe probe = loadProbe("linear").value();
  return performCommand(*command, probe, settings);
}

TEST(ImageLink, CommandsSetAndReadTheSettings) {
  LinkedSettings all{settingsFor(loadProbe("linear").value())};
  const LinkReply set = performed(
      "<Command Name=\"SetUsParameter\"><Parameter Name=\"DepthMm\" Value=\"50\"/><Parameter Name=\"GainPercent\" "
      "Value=\"75\"/><Parameter Name=\"FrequencyMhz\" Value=\"10.5\"/><Parameter Name=\"DynRangeDb\" Value=\"70\"/>"
      "<Parameter Name=\"FocusMm\" Value=\"25\"/><Parameter Name=\"Freeze\" Value=\"TRUE\"/></Command>",
      all);
  EXPECT_TRUE(set.success) << set.sentence;
  EXPECT_EQ(all.settings.depth_mm, 50);
  EXPECT_EQ(all.settings.gain_dB, 20);
  EXPECT_EQ(all.settings.frequency_MHz, 10.5);
  EXPECT_EQ(all.settings.dynamicRange_dB, 70);
  EXPECT_EQ(all.settings.focus_mm, 25);
  EXPECT_TRUE(all.frozen);
  const LinkReply got = performed(
      "<Command Name=\"GetUsParameter\" UsDeviceId=\"VideoDevice\"><Parameter Name=\"Depth\"/><Parameter "
      "Name=\"GainDb\"/><Parameter Name=\"Freeze\"/></Command>",
      all);
  EXPECT_TRUE(got.success);
  EXPECT_EQ(got.sentence, "Depth is 50. GainDb is 20. Freeze is TRUE.");
  EXPECT_EQ(got.parameters.at(1).value, "20");
}

TEST(ImageLink, CommandsOutOfRangeChangeNothing) {
  LinkedSettings all{settingsFor(loadProbe("linear").value())};
  const double depth_mm = all.settings.depth_mm;
  for (const char* value : {"5000", "-1", "nan", "inf", "", "fifty", "50 mm"}) {
    const LinkReply reply = performed(
        std::string("<Command Name=\"SetUsParameter\"><Parameter Name=\"DepthMm\" Value=\"") + value + "\"/></Command>",
        all);
    EXPECT_FALSE(reply.success) << value;
    EXPECT_FALSE(reply.parameters.at(0).success);
    EXPECT_FALSE(reply.sentence.empty());
    EXPECT_EQ(all.settings.depth_mm, depth_mm);
  }
  const LinkReply mixed = performed(
      "<Command Name=\"SetUsParameter\"><Parameter Name=\"Zoom\" Value=\"2\"/><Parameter Name=\"DepthMm\" "
      "Value=\"45\"/></Command>",
      all);
  EXPECT_FALSE(mixed.success);
  EXPECT_EQ(mixed.sentence,
            "There is no parameter 'Zoom'. Known are DepthMm, FrequencyMhz, FocusMm, GainPercent, GainDb, DynRangeDb, "
            "Freeze. DepthMm is 45.");
  EXPECT_EQ(all.settings.depth_mm, 45);
  EXPECT_EQ(performed("<Command Name=\"StartRecording\"/>", all).sentence,
            "There is no command 'StartRecording'. Known are SetUsParameter and GetUsParameter.");
  EXPECT_EQ(performed("<Command Name=\"GetUsParameter\"/>", all).sentence, "The command names no Parameter.");
}

}  // namespace
}  // namespace insonate
