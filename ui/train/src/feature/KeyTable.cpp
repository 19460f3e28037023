#include "KeyTable.h"

#include <QKeyEvent>

namespace insonate::train {
namespace {

using enum HandAxis;

constexpr KeyRow move(int key, HandAxis axis, double step, double wide, const char* keys, const char* meaning) {
  return {key, false, Command::Move, axis, step, wide, 0, keys, meaning};
}
constexpr KeyRow plain(int key, Command command, const char* keys, const char* meaning, bool control = false) {
  return {key, control, command, {}, 0, 0, 0, keys, meaning};
}
constexpr KeyRow recall(int place, const char* keys, const char* meaning) {
  return {Qt::Key_1 + place, false, Command::Recall, {}, 0, 0, place, keys, meaning};
}

constexpr KeyRow tissue(int key, int what, const char* keys, const char* meaning) {
  return {key, false, Command::ShowTissue, {}, 0, 0, what, keys, meaning};
}
constexpr KeyRow window(int place, const char* keys, const char* meaning) {
  return {Qt::Key_1 + place, false, Command::SliceWindow, {}, 0, 0, place, keys, meaning, true};
}

constexpr KeyRow needle(int key, NeedleAxis axis, double step, double wide, const char* keys, const char* meaning,
                        bool alt = true) {
  return {key, false, Command::MoveNeedle, {}, step, wide, 0, keys, meaning, alt, axis};
}

constexpr KeyRow kKeys[] = {
    move(Qt::Key_Left, Lateral, -1, -5, "Arrows", "slide the probe 1 mm (Shift 5 mm)"),
    move(Qt::Key_Right, Lateral, 1, 5, "", ""),
    move(Qt::Key_Up, Elevation, -1, -5, "", ""),
    move(Qt::Key_Down, Elevation, 1, 5, "", ""),
    move(Qt::Key_Q, Rotation, -2, -10, "Q, E", "rotate 2 degrees (Shift 10)"),
    move(Qt::Key_E, Rotation, 2, 10, "", ""),
    move(Qt::Key_W, Tilt, 1, 5, "W, S", "tilt 1 degree (Shift 5)"),
    move(Qt::Key_S, Tilt, -1, -5, "", ""),
    move(Qt::Key_A, Rock, -1, -5, "A, D", "rock 1 degree (Shift 5)"),
    move(Qt::Key_D, Rock, 1, 5, "", ""),
    // On many keyboards plus needs shift: no wide steps here.
    move(Qt::Key_Plus, Press, 0.5, 0.5, "+, -", "press 0.5 mm more, or less; held: smoothly on"),
    move(Qt::Key_Equal, Press, 0.5, 0.5, "", ""),
    move(Qt::Key_Minus, Press, -0.5, -0.5, "", ""),
    plain(Qt::Key_Return, Command::Attempt, "Ctrl+Return", "begin an attempt, or finish it", true),
    plain(Qt::Key_Enter, Command::Attempt, "", "", true),
    plain(Qt::Key_B, Command::Draw, "B", "draw on the syringe, or no longer"),
    plain(Qt::Key_U, Command::NewNeedle, "U", "a new needle, once the old one is out of the skin"),
    plain(Qt::Key_H, Command::CutAtNeedle, "H", "open the patient in 3D along the needle, and back"),
    plain(Qt::Key_J, Command::ShowCourse, "J", "levels, your attempts and the questionnaire, and back"),
    plain(Qt::Key_I, Command::TakeNeedle, "I", "take up the needle beside the probe, or lay it down"),
    needle(Qt::Key_PageDown, NeedleAxis::Advance, 1, 5, "Page Down, Page Up",
           "advance the needle 1 mm, or withdraw it (Shift 5 mm)", false),
    needle(Qt::Key_PageUp, NeedleAxis::Advance, -1, -5, "", "", false),
    // Alt with the probe's keys is the needle.
    needle(Qt::Key_Left, NeedleAxis::Lateral, -1, -5, "Alt+arrows", "slide the needle's entry 1 mm (Shift 5 mm)"),
    needle(Qt::Key_Right, NeedleAxis::Lateral, 1, 5, "", ""),
    needle(Qt::Key_Up, NeedleAxis::Elevation, -1, -5, "", ""),
    needle(Qt::Key_Down, NeedleAxis::Elevation, 1, 5, "", ""),
    needle(Qt::Key_Q, NeedleAxis::Heading, -2, -10, "Alt+Q, Alt+E",
           "turn the needle over the skin 2 degrees (Shift 10)"),
    needle(Qt::Key_E, NeedleAxis::Heading, 2, 10, "", ""),
    needle(Qt::Key_W, NeedleAxis::Angle, 1, 5, "Alt+W, Alt+S", "the needle steeper or flatter, 1 degree (Shift 5)"),
    needle(Qt::Key_S, NeedleAxis::Angle, -1, -5, "", ""),
    needle(Qt::Key_A, NeedleAxis::Bevel, -10, -90, "Alt+A, Alt+D", "rotate the needle's bevel 10 degrees (Shift 90)"),
    needle(Qt::Key_D, NeedleAxis::Bevel, 10, 90, "", ""),
    plain(Qt::Key_Space, Command::Freeze, "Space, F", "freeze the image, and live again"),
    plain(Qt::Key_F, Command::Freeze, "", ""),
    plain(Qt::Key_Comma, Command::EarlierPicture, "Comma, Period", "one image back or on, while frozen"),
    plain(Qt::Key_Period, Command::LaterPicture, "", ""),
    plain(Qt::Key_Home, Command::Home, "Home", "back to the start position"),
    recall(0, "1 to 9", "recall a position of the list"),
    recall(1, "", ""),
    recall(2, "", ""),
    recall(3, "", ""),
    recall(4, "", ""),
    recall(5, "", ""),
    recall(6, "", ""),
    recall(7, "", ""),
    recall(8, "", ""),
    plain(Qt::Key_Z, Command::Undo, "Ctrl+Z, Z", "take back a move, a setting, a deletion", true),
    plain(Qt::Key_Z, Command::Undo, "", ""),
    plain(Qt::Key_Y, Command::Redo, "Ctrl+Y, Y", "do again what was taken back", true),
    plain(Qt::Key_Y, Command::Redo, "", ""),
    plain(Qt::Key_L, Command::MeasureDistance, "L, O, V", "measure a distance, an ellipse, an angle"),
    plain(Qt::Key_O, Command::MeasureEllipse, "", ""),
    plain(Qt::Key_V, Command::MeasureAngle, "", ""),
    plain(Qt::Key_Escape, Command::StopMeasuring, "Esc", "measure no more"),
    plain(Qt::Key_Delete, Command::ClearMeasures, "Delete", "remove the measurements"),
    plain(Qt::Key_N, Command::NextEffect, "N, Shift+N", "one effect of the image by itself: the next, the one before"),
    plain(Qt::Key_0, Command::WholePicture, "0", "the whole image again"),
    plain(Qt::Key_C, Command::CtBeside, "C", "the CT of the same plane beside the image, and back"),
    tissue(Qt::Key_T, 0, "T", "lines of the displaced tissue over the image, and back"),
    tissue(Qt::Key_P, 1, "P", "pressure in the tissue over the image, in kPa, and back"),
    tissue(Qt::Key_K, 2, "K", "curve: area of vein and artery against the force, and back"),
    plain(Qt::Key_X, Command::AllSlices, "X", "probe plane, axial, coronal and sagittal CT at once, and back"),
    window(0, "Alt+1 to Alt+5", "window of the CT: soft tissue, bone, lung, abdomen, brain"),
    window(1, "", ""),
    window(2, "", ""),
    window(3, "", ""),
    window(4, "", ""),
    plain(Qt::Key_P, Command::SavePicture, "Ctrl+P", "save the image", true),
};

constexpr MouseRow kMouse[] = {
    {"Left drag on the image", "slide the probe"},
    {"Right drag on the image", "rotate; with Shift tilt and rock"},
    {"Wheel on the image", "press; with Ctrl change the depth"},
    {"Left drag on the skin (3D)", "put the probe there; with Ctrl the needle's entry"},
    {"Shift + wheel on the image or 3D", "advance the needle, or withdraw it"},
    {"G, Ctrl + arrows", "next handle of the field of view, and move it (Edit probe; Shift: 5)"},
    {"Pointing at image or CT", "marks the same place in the other"},
    {"Wheel on the CT slice", "other slices; probe plane and with Ctrl: zoom"},
    {"Right drag on the CT slice", "window and level"},
    {"Left, middle drag on the CT slice", "crosshair; shift the slice"},
    {"Arrows, Page keys in the CT slice", "other slices"},
    {"G, A, D, R in the CT slice", "structures on and off, fainter, stronger; fit again"},
};

}  // namespace

std::span<const KeyRow> keyTable() {
  return kKeys;
}

std::span<const MouseRow> mouseTable() {
  return kMouse;
}

const KeyRow* rowFor(const QKeyEvent& event) {
  if (event.modifiers() & Qt::MetaModifier) return nullptr;
  const bool alt = event.modifiers() & Qt::AltModifier;
  const bool control = event.modifiers() & Qt::ControlModifier;
  for (const KeyRow& row : kKeys)
    if (row.key == event.key() && row.control == control && row.alt == alt) return &row;
  return nullptr;
}

}  // namespace insonate::train
