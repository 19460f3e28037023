#include <insonate/prepare/PrepareWorkspace.h>
#include <insonate/review/ReviewWorkspace.h>
#include <insonate/train/TrainWorkspace.h>
#include <insonate/ui/MainWindow.h>

#include <gtest/gtest.h>

#include <QAction>
#include <QKeySequence>
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace insonate::ui {
namespace {

/// A key that has another meaning in a workspace than in the window, on purpose.
struct SharedKey {
  const char *window, *workspace;  ///< ids of the commands
};
constexpr SharedKey kShared[] = {
    // F5 reads again what is shown: the class on its page, else the case.
    {"window.case.reload", "review.class.refresh"},
};

/// The keys of a command as integers of QKeySequence.
std::set<int> jsonKeys(Commands& commands, const Command& command) {
  std::set<int> keys;
  for (const CommandKey& one : command.keys) {
    keys.insert(int(one.modifiers) | one.key);
    // Shift takes the wide step.
    keys.insert(int(one.modifiers | Qt::ShiftModifier) | one.key);
  }
  if (!command.keys.empty()) return keys;
  QList<QKeySequence> handled = commands.action(command.id)->shortcuts();
  if (handled.isEmpty() && !command.listed.isEmpty()) handled << QKeySequence(command.listed, QKeySequence::NativeText);
  for (const QKeySequence& one : handled) {
    EXPECT_EQ(one.count(), 1) << command.id.toStdString() << ": " << one.toString().toStdString();
    keys.insert(one[0]);
  }
  return keys;
}

bool isShared(const QString& window, const QString& workspace) {
  return std::ranges::any_of(kShared, [&](const SharedKey& one) {
    return window == QLatin1String(one.window) && workspace == QLatin1String(one.workspace);
  });
}

class KeyList : public testing::Test {
 protected:
  KeyList() {
    window.addWorkspace("prepare", "Prepare", "prepare", workspaces[0].second);
    window.addWorkspace("train", "Train", "train", workspaces[1].second);
    window.addWorkspace("review", "Review", "review", workspaces[2].second);
  }
  ~KeyList() override { window.closeAtOnce(); }

  MainWindow window;
  std::vector<std::pair<QString, Workspace*>> workspaces = {{"Prepare", new prepare::PrepareWorkspace(window.tasks())},
                                                            {"Train", new train::TrainWorkspace},
                                                            {"Review", new review::ReviewWorkspace(window.tasks())}};
};

/// Number of lines about a command in the sections of its place; "" for the window.
long countOf(const Command& command, const std::vector<ShortcutGroup>& list, const QString& place) {
  long count = 0;
  for (const ShortcutGroup& group : list) {
    const bool isOfWorkspace = group.place.contains(QLatin1String(": "));
    if (place.isEmpty() ? isOfWorkspace : !group.place.startsWith(place)) continue;
    count += std::ranges::count_if(
        group.shortcuts, [&](const Shortcut& one) { return one.keys == command.listed && one.does == command.does; });
  }
  return count;
}

TEST_F(KeyList, HasEachCommandOfEachPlaceOnce) {
  const auto expectOnce = [this](const Commands& commands, const QString& place) {
    for (const Command& one : commands.all()) {
      if (!one.listed.isEmpty()) {
        EXPECT_EQ(countOf(one, window.keyList(), place), 1) << one.id.toStdString();
      }
      EXPECT_TRUE(one.keys.empty() || !one.listed.isEmpty()) << one.id.toStdString() << " has a key and is not listed";
      EXPECT_FALSE(one.does.isEmpty()) << one.id.toStdString();
    }
  };
  EXPECT_GT(window.commands().all().size(), 15U);
  EXPECT_GT(workspaces[2].second->commands().all().size(), 15U);
  expectOnce(window.commands(), {});
  for (const auto& [title, workspace] : workspaces) expectOnce(workspace->commands(), title);
}

TEST_F(KeyList, NoKeyHasTwoMeanings) {
  std::map<int, QString> ofWindow;
  for (const Command& one : window.commands().all())
    for (const int key : jsonKeys(window.commands(), one))
      EXPECT_TRUE(ofWindow.emplace(key, one.id).second)
          << one.id.toStdString() << ", " << QKeySequence(key).toString().toStdString();
  EXPECT_EQ(ofWindow.at(int(Qt::CTRL) + Qt::Key_O), "window.case.open");
  std::size_t shared = 0;
  for (const auto& [title, workspace] : workspaces) {
    std::map<int, QString> ofWorkspace;
    for (const Command& one : workspace->commands().all())
      for (const int key : jsonKeys(workspace->commands(), one)) {
        const std::string what = one.id.toStdString() + ", " + QKeySequence(key).toString().toStdString();
        EXPECT_TRUE(ofWorkspace.emplace(key, one.id).second) << what << " has two meanings in one workspace";
        const auto other = ofWindow.find(key);
        if (other == ofWindow.end()) continue;
        EXPECT_TRUE(isShared(other->second, one.id)) << what << " is also " << other->second.toStdString();
        shared += isShared(other->second, one.id);
      }
  }
  EXPECT_EQ(shared, std::size(kShared)) << "each exception is needed";
}

}  // namespace
}  // namespace insonate::ui
