#pragma once

#include <insonate/haptics/HapticServo.h>

#include <QString>

class QSettings;

namespace insonate::train {

/// Side of the patient, who lies supine, from which a device is used.
enum class Stand { Head, Right, Left, Feet };

/// The user's mapping of a device to a tool; kept for each device. Motion and force are one to one: only then do they
/// convey truly how hard tissue is.
struct HandMapping {
  Stand stand = Stand::Head;
  Transform begin;  ///< deviceFromStylus where the tool is to be at its start
  Vec3 apart_mm;    ///< device frame: from the device to its tool
  double gain = 1;  ///< 0..1, of forces
  double mostForce_N = 3;
};

/// Such that the stylus held as `begin` holds the tool at `patientFromStart`. Limits come with the device.
HandSetup setupOf(const HandMapping& mapping, const Transform& patientFromStart);

/// Saves to the group of the device; missing or invalid values take their defaults when read.
void save(const HandMapping& mapping, QSettings& settings);
HandMapping restoredMapping(const QSettings& settings);

}  // namespace insonate::train
