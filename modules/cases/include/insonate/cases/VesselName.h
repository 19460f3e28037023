#pragma once

#include <insonate/tissue/Labels.h>

#include <optional>
#include <string_view>

namespace insonate {

/// Vessels that the program distinguishes by their names.
enum class KnownVessel {
  Jugular,  ///< a jugular vein whose name does not state which one
  InternalJugular,
  ExternalJugular,
  AnteriorJugular,
  Subclavian,
  Axillary,
  Brachiocephalic,
  Carotid,  ///< a carotid artery whose name does not state which one
  CommonCarotid,
  InternalCarotid,
  ExternalCarotid,
  Vertebral,
  Iliac,
  Femoral,    ///< also the common, superficial and deep femoral vessels
  Saphenous,  ///< great or small saphenous vein
  Brachial,
  Basilic,
  Cephalic
};

enum class BodySide { Right, Left };

/// Meaning of a vessel's name. A member is empty if the name does not state the property.
struct VesselName {
  std::optional<KnownVessel> vessel{};
  std::optional<BodySide> side{};  ///< side of the body; also empty if the name states both sides
  std::optional<Label> label{};    ///< kVein or kArtery
};

/// Reads a name in English, German, French, Spanish or Latin (Terminologia Anatomica), e.g. "V. jugularis interna
/// rechts", regardless of case and accents. `name` is UTF-8.
VesselName parsedVesselName(std::string_view name);

/// Tells whether `name` contains the text `vessel`, or whether both name the same vessel, possibly in different
/// languages. The side, and the words vein and artery, are compared only if both texts state them.
bool namesVessel(std::string_view name, std::string_view vessel);

}  // namespace insonate
