#include "KeyTable.h"

#include <QKeyEvent>

namespace insonate::review {
namespace {

constexpr double kPicture_s = 1.0 / 30;

constexpr KeyRow kKeys[] = {
    {Qt::Key_Space, Command::Play, 0, 0, "Space", "play, and stop"},
    {Qt::Key_Comma, Command::Step, -kPicture_s, -kPicture_s, "Comma, Period", "one image, 1/30 s, back or on"},
    {Qt::Key_Period, Command::Step, kPicture_s, kPicture_s, "", ""},
    {Qt::Key_Left, Command::Step, -1, -10, "Left, Right", "one second back or on (Shift 10 s)"},
    {Qt::Key_Right, Command::Step, 1, 10, "", ""},
    {Qt::Key_PageUp, Command::StepMoment, -1, -1, "Page Up, Page Down", "previous and next moment"},
    {Qt::Key_PageDown, Command::StepMoment, 1, 1, "", ""},
    {Qt::Key_Home, Command::Begin, 0, 0, "Home, End", "to the begin or the end of the attempt"},
    {Qt::Key_End, Command::End, 0, 0, "", ""},
    {Qt::Key_Minus, Command::Slower, 0, 0, "-, +", "slower, faster"},
    {Qt::Key_Plus, Command::Faster, 0, 0, "", ""},
    {Qt::Key_Equal, Command::Faster, 0, 0, "", ""},
    {Qt::Key_1, Command::ShowReplay, 0, 0, "1, 2", "the replay, the result"},
    {Qt::Key_2, Command::ShowResult, 0, 0, "", ""},
    {Qt::Key_3, Command::ShowLook, 0, 0, "3", "what 3D shows: structures, skin, clipping plane; or no longer"},
    {Qt::Key_4, Command::ShowJudging, 0, 0, "4", "checklists and ratings beside the replay; or no longer"},
    {Qt::Key_Backspace, Command::List, 0, 0, "Backspace", "back to the list of attempts"},
    {0, {}, 0, 0, "Alt+1 to 5", "class, person, comparison, recordings, raters, for who has signed in"},
    {0, {}, 0, 0, "F5", "ask for new people and attempts of the class"},
    {0, {}, 0, 0, "Delete", "take a person's attempt out of the count, with a reason"},
    {0, {}, 0, 0, "Ctrl+Shift+E", "save a plot as PNG, SVG or PDF"},
    {0, {}, 0, 0, "Ctrl+E", "save the result, the class or the person"},
    {0, {}, 0, 0, "Click, drag on the timeline", "go to a time, or to the moment of a mark"},
    {0, {}, 0, 0, "Wheel on the timeline", "magnify (Shift: move along); double click: all of it"},
    {0, {}, 0, 0, "Left drag in 3D, wheel, R", "turn, come nearer, look from the front"},
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

}  // namespace insonate::review
