#pragma once

#include <insonate/haptics/HapticServo.h>

#include <QString>

class QSettings;

namespace insonate::train {

/// Side of the supine patient at which the user of a device stands.
enum class Stand { Head, Right, Left, Feet };

/// The user's mapping of a device to a tool, saved for each device. Motion and force are mapped one to one, since only
/// then is the hardness of tissue conveyed correctly.
struct HandMapping {
  Stand stand = Stand::Head;
  Transform begin;  ///< pose of the stylus in the device's frame at which the tool is at its start pose
  Vec3 apart_mm;    ///< offset from the device to its tool, in the device's frame
  double gain = 1;  ///< factor of forces, 0 to 1
  double userMaxForce_N = 3;
};

/// Returns a setup in which the tool is at `patientFromStart` when the stylus is at `begin`. The limits are those of
/// the device.
ToolSetup setupOf(const HandMapping& mapping, const Transform& patientFromStart);

/// Returns the setup for a device that measures in the frame of a registered desk.
ToolSetup setupOnDesk(const HandMapping& mapping, const Transform& patientFromOutline);

/// Saves the mapping in the settings group of the device. When the mapping is read, missing or invalid values get their
/// defaults.
void save(const HandMapping& mapping, QSettings& settings);
HandMapping restoredMapping(const QSettings& settings);

}  // namespace insonate::train
