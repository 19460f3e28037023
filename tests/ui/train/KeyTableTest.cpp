#include "feature/KeyTable.h"

#include <gtest/gtest.h>

#include <QKeyEvent>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace insonate::train {
namespace {

QKeyEvent pressed(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  return QKeyEvent(QEvent::KeyPress, key, modifiers);
}

TEST(KeyTable, EachKeyHasOneMeaning) {
  std::set<std::tuple<int, bool, bool>> seen;
  for (const KeyRow& row : keyTable()) EXPECT_TRUE(seen.emplace(row.key, row.control, row.alt).second) << row.key;
}

TEST(KeyTable, OppositeKeysUndoEachOther) {
  for (const auto& [one, other] : {std::pair{Qt::Key_Left, Qt::Key_Right},
                                   {Qt::Key_Up, Qt::Key_Down},
                                   {Qt::Key_Q, Qt::Key_E},
                                   {Qt::Key_W, Qt::Key_S},
                                   {Qt::Key_A, Qt::Key_D},
                                   {Qt::Key_Plus, Qt::Key_Minus}}) {
    const KeyRow* a = rowFor(pressed(one));
    const KeyRow* b = rowFor(pressed(other));
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->axis, b->axis);
    EXPECT_EQ(a->step, -b->step);
    EXPECT_EQ(a->wide, -b->wide);
  }
}

TEST(KeyTable, ControlMakesAnotherKey) {
  EXPECT_EQ(rowFor(pressed(Qt::Key_S))->axis, HandAxis::Tilt);
  EXPECT_EQ(rowFor(pressed(Qt::Key_P, Qt::ControlModifier))->command, Command::SavePicture);
  EXPECT_FALSE(rowFor(pressed(Qt::Key_S, Qt::ControlModifier))) << "saves the case, in every workspace";
  EXPECT_EQ(rowFor(pressed(Qt::Key_Z, Qt::ControlModifier))->command, Command::Undo);
  EXPECT_FALSE(rowFor(pressed(Qt::Key_F, Qt::ControlModifier)));
  EXPECT_EQ(rowFor(pressed(Qt::Key_Left, Qt::AltModifier))->command, Command::MoveNeedle) << "Alt is the needle";
  EXPECT_EQ(rowFor(pressed(Qt::Key_S, Qt::AltModifier))->needle, NeedleAxis::Angle);
  EXPECT_FALSE(rowFor(pressed(Qt::Key_I, Qt::AltModifier)));
}

TEST(KeyTable, NumbersRecallInOrder) {
  for (int n = 0; n < 9; ++n) {
    const KeyRow* row = rowFor(pressed(Qt::Key_1 + n));
    ASSERT_TRUE(row);
    EXPECT_EQ(row->command, Command::Recall);
    EXPECT_EQ(row->place, n);
  }
}

TEST(KeyTable, WhatIsListedIsExplained) {
  for (const KeyRow& row : keyTable()) EXPECT_EQ(std::string(row.keys).empty(), std::string(row.meaning).empty());
}

}  // namespace
}  // namespace insonate::train
