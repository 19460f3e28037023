#include "model/History.h"

#include <gtest/gtest.h>

#include <QString>
#include <utility>

namespace insonate::train {
namespace {

/// A number that is changed, with its history.
struct Changed {
  History history;
  int value = 0;
  bool mayChange = true;

  void set(int next, const QString& key = {}) {
    history.add(
        QString("number %1").arg(next),
        [this, other = std::exchange(value, next)]() mutable { std::swap(value, other); }, key,
        [this] { return mayChange; });
  }
};

TEST(History, TakesBackAndDoesAgainInOrder) {
  Changed number;
  number.set(1), number.set(2), number.set(3);
  EXPECT_EQ(number.history.undo(), History::Outcome::Done);
  EXPECT_EQ(number.history.lastStepName().toStdString(), "number 3");
  number.history.undo();
  EXPECT_EQ(number.value, 1);
  number.history.redo();
  EXPECT_EQ(number.value, 2);
  EXPECT_EQ(number.history.lastStepName().toStdString(), "number 2");
  number.history.undo(), number.history.undo();
  EXPECT_EQ(number.value, 0);
  EXPECT_EQ(number.history.undo(), History::Outcome::Nothing);
}

TEST(History, SomethingNewEndsWhatCouldBeDoneAgain) {
  Changed number;
  number.set(1), number.set(2);
  number.history.undo();
  number.set(7);
  EXPECT_EQ(number.history.redo(), History::Outcome::Nothing);
  number.history.undo();
  EXPECT_EQ(number.value, 1);
}

TEST(History, StepsOfOneKeyAreOne) {
  Changed number;
  number.set(1, "slider"), number.set(2, "slider"), number.set(3, "slider");
  number.set(4, "other");
  number.history.close();
  number.set(5, "other");
  number.history.undo();
  EXPECT_EQ(number.value, 4);
  number.history.undo();
  EXPECT_EQ(number.value, 3);
  number.history.undo();
  EXPECT_EQ(number.value, 0);
  number.set(1, "slider");
  number.history.undo();
  EXPECT_EQ(number.value, 0) << "a step after undo does not join the one before";
}

TEST(History, WhatIsRefusedStays) {
  Changed number;
  number.set(1);
  number.mayChange = false;
  EXPECT_EQ(number.history.undo(), History::Outcome::Refused);
  number.mayChange = true;
  EXPECT_EQ(number.history.undo(), History::Outcome::Done);
  EXPECT_EQ(number.value, 0);
  number.mayChange = false;
  EXPECT_EQ(number.history.redo(), History::Outcome::Refused);
  EXPECT_EQ(number.value, 0);
  number.mayChange = true;
  EXPECT_EQ(number.history.redo(), History::Outcome::Done);
  EXPECT_EQ(number.value, 1);
}

TEST(History, ClearingEndsUndoAndRedo) {
  Changed number;
  number.set(1, "slider"), number.set(2, "other");
  number.history.undo();
  number.history.clear();
  EXPECT_EQ(number.history.undo(), History::Outcome::Nothing);
  EXPECT_EQ(number.history.redo(), History::Outcome::Nothing);
  number.set(7, "slider");
  number.history.undo();
  EXPECT_EQ(number.value, 1);
}

TEST(History, ForgetsTheOldestOfManySteps) {
  Changed number;
  for (int i = 1; i <= History::kMost + 5; ++i) number.set(i);
  while (number.history.undo() == History::Outcome::Done) {
  }
  EXPECT_EQ(number.value, 5);
}

}  // namespace
}  // namespace insonate::train
