#pragma once

namespace insonate::ui {

/// Devices with which a user moves probe and needle, as chosen at the first start.
enum class HandsChoice { Mouse, Camera, Controller, Haptic };

}  // namespace insonate::ui
