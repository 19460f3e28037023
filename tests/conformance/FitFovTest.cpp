#include <gtest/gtest.h>
#include <support/FovCapture.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <string>

namespace insonate {
namespace {

using test::FovCapture;

FovShape curvilinear(double rotation_deg) {
  FovShape shape;
  shape.shape = ProbeShape::Curvilinear;
  shape.origin = {480, -40}, shape.rotation_deg = rotation_deg;
  shape.alpha_deg = 62, shape.r1_px = 140, shape.r2_px = 700;
  return shape;
}
FovShape shallowCurve(double rotation_deg) {
  FovShape shape = curvilinear(rotation_deg);
  shape.origin = {470, -430}, shape.alpha_deg = 48, shape.r1_px = 520, shape.r2_px = 1060;
  return shape;
}
FovShape phased(double rotation_deg) {
  FovShape shape = curvilinear(rotation_deg);
  shape.shape = ProbeShape::Phased;
  shape.origin = {470, 50}, shape.alpha_deg = 84, shape.r1_px = 4, shape.r2_px = 600;
  return shape;
}
FovShape linear(double rotation_deg) {
  FovShape shape;
  shape.origin = {450, 70}, shape.rotation_deg = rotation_deg;
  shape.width_px = 480, shape.depth_px = 540;
  return shape;
}

struct Row {
  std::string name;
  FovCapture capture;
};

/// One hard thing after the other, then several at once.
std::vector<Row> variationsOf(const std::string& name, const FovShape& shape, unsigned seed) {
  FovCapture plain;
  plain.shape = shape, plain.seed = seed;
  std::vector<Row> rows;
  const auto add = [&](const std::string& what, const auto& change) {
    FovCapture capture = plain;
    change(capture);
    rows.push_back({name + ", " + what, capture});
  };
  add("plain", [](FovCapture&) {});
  add("text and bars", [](FovCapture& c) { c.text = c.bars = true, c.mark_px = 52; });
  add("grey ground", [](FovCapture& c) { c.ground = 18, c.slope = 8, c.noise = 2, c.mark_px = 40, c.longEvery = 5; });
  add("noise", [](FovCapture& c) { c.noise = 7, c.text = true, c.mark_px = 60; });
  add("artefacts", [](FovCapture& c) { c.artefacts = c.text = true, c.mark_px = 45; });
  add("dark at the sides", [](FovCapture& c) { c.darkLeft = c.text = true; });
  add("dark at the end", [](FovCapture& c) { c.darkEnd = c.shadows = true, c.mark_px = 30, c.longEvery = 2; });
  add("right side cut off", [](FovCapture& c) { c.cutRight = 0.3, c.bars = true; });
  add("end cut off", [](FovCapture& c) { c.cutEnd = 0.06, c.text = true; });
  add("dark echoes on a light background", [](FovCapture& c) { c.darkOnLight = c.text = true, c.mark_px = 50; });
  add("all at once", [](FovCapture& c) {
    c.text = c.bars = c.artefacts = c.darkLeft = c.shadows = true;
    c.ground = 10, c.noise = 3, c.mark_px = 55;
  });
  return rows;
}

std::vector<Row> table() {
  std::vector<Row> rows;
  const auto append = [&](std::vector<Row> more) { rows.insert(rows.end(), more.begin(), more.end()); };
  append(variationsOf("curvilinear", curvilinear(0), 1));
  append(variationsOf("shallow curve turned -3", shallowCurve(-3), 3));
  append(variationsOf("phased turned -5", phased(-5), 5));
  append(variationsOf("linear", linear(0), 6));
  append(variationsOf("linear turned 4", linear(4), 7));
  unsigned seed = 100;
  for (const double turn : {-5.0, -2.5, 2.5, 5.0}) {
    for (FovShape shape : {curvilinear(turn), phased(turn), linear(turn)}) {
      FovCapture capture;
      capture.shape = shape, capture.seed = seed++, capture.text = capture.bars = true, capture.mark_px = 48;
      rows.push_back({"turned " + std::to_string(turn) + " " + std::to_string(int(shape.shape)), capture});
    }
  }
  for (FovShape shape : {curvilinear(2), phased(-2)}) {
    shape.upsideDown = true, shape.origin.y = 719 - shape.origin.y;
    FovCapture capture;
    capture.shape = shape, capture.seed = seed++, capture.text = true, capture.mark_px = 50;
    rows.push_back({"upside down", capture});
  }
  return rows;
}

/// Errors of a fit, by name: degrees, or per cent.
std::map<std::string, double> errorsOf(const FovFit& fit, const FovCapture& capture) {
  const FovShape &is = fit.shape, &was = capture.shape;
  std::map<std::string, double> errors{{"rotation_deg", std::abs(is.rotation_deg - was.rotation_deg)}};
  const auto percent = [](double value, double truth, double of) { return 100 * std::abs(value - truth) / of; };
  if (was.shape == ProbeShape::Linear) {
    if (capture.cutRight == 0) errors["width_percent"] = percent(is.width_px, was.width_px, was.width_px);
    if (capture.cutEnd == 0) errors["depth_percent"] = percent(is.depth_px, was.depth_px, was.depth_px);
  } else {
    errors["alpha_deg"] = std::abs(is.alpha_deg - was.alpha_deg);
    errors["r2_percent"] = percent(is.r2_px, was.r2_px, was.r2_px);
    // A phased array's face is hardly more than a point.
    errors["r1_percent"] = percent(is.r1_px, was.r1_px, was.shape == ProbeShape::Phased ? was.r2_px : was.r1_px);
  }
  if (capture.mark_px > 0)
    errors["scale_percent"] = fit.ruler ? percent(fit.ruler->spacing_px, capture.mark_px, capture.mark_px) : 100;
  return errors;
}

bool saidToBe(const FovFit& fit, const std::string& words) {
  return std::ranges::any_of(fit.warnings, [&](const std::string& doubt) { return doubt.find(words) != doubt.npos; });
}

TEST(FitFov, Captures) {
  std::map<std::string, double> worst;
  const char* keep = std::getenv("INSONATE_KEEP_CAPTURES");
  int number = 0;
  for (const Row& row : table()) {
    SCOPED_TRACE(row.name);
    const GrayImage picture = test::paint(row.capture);
    if (keep) {
      std::ofstream file(std::string(keep) + "/capture-" + std::to_string(100 + number) + ".pgm", std::ios::binary);
      file << "P5 " << picture.width << ' ' << picture.height << " 255\n";
      file.write(reinterpret_cast<const char*>(picture.gray.data()), std::streamsize(picture.gray.size()));
    }
    ++number;
    const auto fit = fitFov(picture);
    if (!fit) {
      ADD_FAILURE() << number << ' ' << fit.error().message;
      continue;
    }
    EXPECT_EQ(int(fit->shape.shape), int(row.capture.shape.shape)) << number;
    if (fit->shape.shape != row.capture.shape.shape) continue;
    EXPECT_EQ(fit->shape.upsideDown, row.capture.shape.upsideDown);
    EXPECT_FALSE(saidToBe(*fit, "side by side")) << number << ": it is one picture";
    for (const auto& [name, error] : errorsOf(*fit, row.capture)) {
      worst[name] = std::max(worst[name], error);
      EXPECT_LE(error, name.ends_with("_deg") ? 1.0 : 2.0) << number << ' ' << name;
    }
  }
  RecordProperty("captures", number);
  for (const auto& [name, error] : worst) {
    RecordProperty("worst_" + name, std::to_string(error));
    std::cout << "worst " << name << ' ' << error << '\n';
  }
}

/// A screen with one capture beside the other.
GrayImage screenOf(const GrayImage& left, const GrayImage& right) {
  GrayImage both{left.width + right.width, left.height, {}};
  for (int row = 0; row < left.height; ++row)
    for (const GrayImage* one : {&left, &right}) {
      const auto from = one->gray.begin() + std::ptrdiff_t(row) * one->width;
      both.gray.insert(both.gray.end(), from, from + one->width);
    }
  return both;
}

/// Half a screen, with one image in it.
FovCapture half(ProbeShape kind, unsigned seed) {
  FovCapture capture;
  capture.width = 500, capture.height = 720, capture.seed = seed, capture.shape.shape = kind;
  FovShape& shape = capture.shape;
  shape.origin = {245, 120}, shape.width_px = 420, shape.depth_px = 500;
  if (kind == ProbeShape::Curvilinear)
    shape.origin = {245, 10}, shape.alpha_deg = 50, shape.r1_px = 150, shape.r2_px = 560;
  if (kind == ProbeShape::Phased) shape.origin = {245, 100}, shape.alpha_deg = 54, shape.r1_px = 4, shape.r2_px = 500;
  return capture;
}

void expectFitted(const FovFit& fit, const FovCapture& capture) {
  ASSERT_EQ(int(fit.shape.shape), int(capture.shape.shape));
  for (const auto& [name, error] : errorsOf(fit, capture)) EXPECT_LE(error, name.ends_with("_deg") ? 1.0 : 2.0) << name;
}

TEST(FitFov, OfTwoSideBySideTheLeftOne) {
  unsigned seed = 40;
  for (const ProbeShape kind : {ProbeShape::Linear, ProbeShape::Curvilinear, ProbeShape::Phased})
    for (const double ground : {0.0, 14.0}) {
      SCOPED_TRACE(int(kind));
      FovCapture left = half(kind, seed++), right = half(kind, seed++);
      left.ground = right.ground = ground, left.noise = right.noise = 2;
      const auto fit = fitFov(screenOf(test::paint(left), test::paint(right)));
      ASSERT_TRUE(fit) << fit.error().message;
      EXPECT_TRUE(saidToBe(*fit, "Two images lie side by side; this is the left one."));
      EXPECT_LT(fit->shape.origin.x, 500);
      expectFitted(*fit, left);
    }
}

TEST(FitFov, OfTwoSideBySideTheClearerOne) {
  FovCapture left = half(ProbeShape::Curvilinear, 61), right = half(ProbeShape::Curvilinear, 62);
  left.darkLeft = left.darkEnd = left.shadows = true, left.noise = 4;
  const auto fit = fitFov(screenOf(test::paint(left), test::paint(right)));
  ASSERT_TRUE(fit) << fit.error().message;
  EXPECT_TRUE(saidToBe(*fit, "side by side; this is the right one"));
  EXPECT_GT(fit->shape.origin.x, 500);
  expectFitted(*fit, right);
}

TEST(FitFov, AShadowFromTopToBottomMakesNoTwoOfOne) {
  FovCapture capture;
  capture.shape = linear(0), capture.seed = 71;
  GrayImage picture = test::paint(capture);
  for (int row = 0; row < picture.height; ++row)
    for (int column = 370; column < 395; ++column) picture.gray[std::size_t(row) * picture.width + column] = 0;
  const auto fit = fitFov(picture);
  ASSERT_TRUE(fit) << fit.error().message;
  EXPECT_FALSE(saidToBe(*fit, "side by side"));
  expectFitted(*fit, capture);
}

}  // namespace
}  // namespace insonate
