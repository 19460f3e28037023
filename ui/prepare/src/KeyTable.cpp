#include "KeyTable.h"

#include <QKeyEvent>

namespace insonate::prepare {
namespace {

constexpr KeyRow kKeys[] = {
    {Qt::Key_Q, Command::PreviousStructure, "Q, W", "previous and next structure of the table"},
    {Qt::Key_W, Command::NextStructure},
    {Qt::Key_H, Command::ToggleStructure, "H", "hide or show the selected structure (Space in the table)"},
    {0, {}, "Enter in the table", "color of the selected structure, without a tool in hand"},
    {Qt::Key_A, Command::LabelsFainter, "A, D", "labels on the slices fainter, stronger"},
    {Qt::Key_D, Command::LabelsStronger},
    {Qt::Key_G, Command::ToggleLabels, "G", "hide or show all labels on the slices"},
    {Qt::Key_L, Command::LockStructure, "L", "lock or unlock the selected structure"},
    {Qt::Key_S, Command::NextState, "S", "next state of the selected structure, e.g. completed"},
    {0, {}, "F2 in the table", "name of a structure of your own"},
    {Qt::Key_1, Command::Tool, "1 to 9, 0", "tools of the palette; again for the next of a group"},
    {Qt::Key_2, Command::Tool},
    {Qt::Key_3, Command::Tool},
    {Qt::Key_4, Command::Tool},
    {Qt::Key_5, Command::Tool},
    {Qt::Key_6, Command::Tool},
    {Qt::Key_7, Command::Tool},
    {Qt::Key_8, Command::Tool},
    {Qt::Key_9, Command::Tool},
    {Qt::Key_0, Command::Tool},
    {Qt::Key_Space, Command::LastTool, "Space", "the tool before, and back"},
    {Qt::Key_Return, Command::ApplyTool, "Enter, Esc", "apply the tool; forget its clicks, lay it away"},
    {Qt::Key_Enter, Command::ApplyTool},
    {Qt::Key_Escape, Command::LeaveTool},
    {0, {}, "Delete, Backspace", "take back the tool's last click"},
    {Qt::Key_Plus, Command::LargerBrush, "+, -, [, ], Shift + wheel", "size of the brush"},
    {Qt::Key_Minus, Command::SmallerBrush},
    {Qt::Key_BracketRight, Command::LargerBrush},
    {Qt::Key_BracketLeft, Command::SmallerBrush},
    {Qt::Key_C, Command::CheckPage, "C", "the check beside the slices, and back to the case"},
    {Qt::Key_Home, Command::Start, "Home", "crosshair and probe to where the case begins"},
    {0, {}, "Ctrl+Z, Ctrl+Y", "take back a change, do it again"},
    {0, {}, "Arrows, wheel, Page up and down", "go through the slices"},
    {0, {}, "M, double click", "one view fills the room, and back"},
    {0, {}, "R", "fit the slice into its view; 3D from the front"},
    {0, {}, "Left drag on a slice", "crosshair (with Shift without a button)"},
    {0, {}, "Right drag on a slice", "window (across) and level (along)"},
    {0, {}, "Ctrl + wheel, middle drag", "zoom, pan"},
    {0, {}, "Click on a structure in 3D", "crosshair there"},
    {0, {}, "Left drag in 3D with scissors", "draws what is cut along the view; with Ctrl it turns"},
};

}  // namespace

std::span<const KeyRow> keyTable() {
  return kKeys;
}

const KeyRow* rowFor(const QKeyEvent& event) {
  if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) return nullptr;
  for (const KeyRow& row : kKeys)
    if (row.key != 0 && row.key == event.key()) return &row;
  return nullptr;
}

}  // namespace insonate::prepare
