#include "HandMapping.h"

#include <insonate/simulator/CameraHands.h>

#include <QSettings>
#include <QVariantList>
#include <algorithm>
#include <cmath>

namespace insonate::train {
namespace {

constexpr double kMaxApart_mm = 300, kMaxForce_N = 20;

/// Device axes (x right, y up, z to the user) in patient LPS, the patient on the back.
Mat3 patientFromDevice(Stand stand) {
  const Vec3 up{0, -1, 0};
  const auto seen = [&](Vec3 toUser) { return Mat3{{cross(up, toUser), up, toUser}}; };
  switch (stand) {
    case Stand::Head:
      return seen({0, 0, 1});
    case Stand::Right:
      return seen({-1, 0, 0});
    case Stand::Left:
      return seen({1, 0, 0});
    case Stand::Feet:
      return seen({0, 0, -1});
  }
  return {};
}

bool isRotation(const Mat3& m) {
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b <= a; ++b)
      if (!(std::abs(dot(m.column[a], m.column[b]) - (a == b)) < 1e-3)) return false;
  return determinant(m) > 0;
}

double within(const QSettings& settings, const char* key, double least, double most, double usual) {
  bool ok = false;
  const double value = settings.value(QLatin1String(key)).toDouble(&ok);
  return ok && std::isfinite(value) ? std::clamp(value, least, most) : usual;
}

}  // namespace

ToolSetup setupOf(const HandMapping& mapping, const Transform& patientFromStart) {
  ToolSetup setup;
  const Mat3 turned = patientFromDevice(mapping.stand);
  setup.stylusFromTool.linear = transposed(turned * mapping.begin.linear) * patientFromStart.linear;
  setup.patientFromDevice = {turned, patientFromStart.offset - turned * mapping.begin.offset};
  setup.apart_mm = mapping.apart_mm;
  setup.gain = mapping.gain;
  setup.userMaxForce_N = mapping.userMaxForce_N;
  return setup;
}

ToolSetup setupOnDesk(const HandMapping& mapping, const Transform& patientFromOutline) {
  ToolSetup setup = insonate::setupOnDesk(patientFromOutline);
  setup.apart_mm = mapping.apart_mm;
  setup.gain = mapping.gain;
  setup.userMaxForce_N = mapping.userMaxForce_N;
  return setup;
}

void save(const HandMapping& mapping, QSettings& settings) {
  settings.setValue("stand", int(mapping.stand));
  QVariantList begin;
  for (const Vec3& v : {mapping.begin.linear.column[0], mapping.begin.linear.column[1], mapping.begin.linear.column[2],
                        mapping.begin.offset})
    begin << v.x << v.y << v.z;
  settings.setValue("begin", begin);
  settings.setValue("apartX_mm", mapping.apart_mm.x);
  settings.setValue("apartY_mm", mapping.apart_mm.y);
  settings.setValue("apartZ_mm", mapping.apart_mm.z);
  settings.setValue("gain", mapping.gain);
  settings.setValue("mostForce_N", mapping.userMaxForce_N);
}

HandMapping restoredMapping(const QSettings& settings) {
  HandMapping mapping;
  mapping.stand = Stand(std::clamp(settings.value("stand", 0).toInt(), 0, int(Stand::Feet)));
  const QVariantList list = settings.value("begin").toList();
  if (list.size() == 12) {
    const auto at = [&](int i) {
      return Vec3{list[3 * i].toDouble(), list[3 * i + 1].toDouble(), list[3 * i + 2].toDouble()};
    };
    const Transform begin{{{at(0), at(1), at(2)}}, at(3)};
    if (isRotation(begin.linear) && isFinite(begin.offset)) mapping.begin = begin;
  }
  mapping.apart_mm = {within(settings, "apartX_mm", -kMaxApart_mm, kMaxApart_mm, 0),
                      within(settings, "apartY_mm", -kMaxApart_mm, kMaxApart_mm, 0),
                      within(settings, "apartZ_mm", -kMaxApart_mm, kMaxApart_mm, 0)};
  mapping.gain = within(settings, "gain", 0, 1, 1);
  mapping.userMaxForce_N = within(settings, "mostForce_N", 0, kMaxForce_N, HandMapping{}.userMaxForce_N);
  return mapping;
}

}  // namespace insonate::train
