#pragma once

#include "Waiting.h"

#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/EmptyWorkspace.h>
#include <insonate/ui/MainWindow.h>

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QToolButton>
#include <QUrl>
#include <QtTest/QTest>
#include <memory>
#include <optional>

namespace insonate::test {

inline const QString kAccountPassword = QStringLiteral("a long sentence");

/// The window over a store in a file, which is not there yet.
class AccountWindow : public testing::Test {
 protected:
  void SetUp() override {
    QSettings().clear();
    open();
  }

  void open() {
    window = std::make_unique<ui::MainWindow>(
        std::make_unique<ui::Account>(file(), StoreServices{.passwordCost = PasswordCost::Minimum}));
    window->addWorkspace("train", "Train", "train", new ui::EmptyWorkspace({"train", "Train", {}, {}, {}}));
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    QApplication::setActiveWindow(window.get());
    ASSERT_TRUE(waitUntil([&] { return account().state() != ui::Account::State::Opening; }));
  }

  /// Or a server's address.
  virtual QString file() const { return home.filePath("people/curriculum.sqlite"); }
  ui::Account& account() { return window->account(); }
  QAction& action(const char* name) { return *window->findChild<QAction*>(name); }
  QString header() {
    for (const auto* button : window->findChildren<QToolButton*>())
      if (button->accessibleName() == "Account menu") return button->text().trimmed();
    return {};
  }
  /// The dialog with this field, which comes up in a moment.
  QDialog* dialogWith(const char* field) {
    QDialog* found = nullptr;
    EXPECT_TRUE(waitUntil([&] {
      for (auto* dialog : window->findChildren<QDialog*>())
        if (dialog->isVisible() && dialog->findChild<QWidget*>(field)) found = dialog;
      return found != nullptr;
    })) << field;
    return found;
  }
  void type(QDialog* dialog, const char* field, const QString& text) {
    auto* line = dialog->findChild<QLineEdit*>(field);
    line->selectAll();
    line->clear();
    QTest::keyClicks(line, text);
  }
  static void go(QDialog* dialog) { dialog->findChild<QPushButton*>("entryGo")->click(); }
  static QString error(QDialog* dialog) { return dialog->findChild<QLabel*>("entryTrouble")->text(); }

  void setUp() {
    action("accountSetUp").trigger();
    QDialog* dialog = dialogWith("setUpName");
    type(dialog, "setUpName", "ada");
    type(dialog, "setUpFullName", "Ada L.");
    type(dialog, "setUpPassword", kAccountPassword);
    type(dialog, "setUpAgain", kAccountPassword);
    go(dialog);
    ASSERT_TRUE(waitUntil([&] { return account().isSignedIn(); }));
  }
  Result<void> setUpAlone(const QString& fullName, const QString& password) {
    std::optional<Result<void>> outcome;
    account().setUpAlone(fullName, password, [&](const Result<void>& result) { outcome = result; });
    EXPECT_TRUE(waitUntil([&] { return outcome.has_value(); }));
    return outcome.value_or(fail("no answer came"));
  }
  void signOut() {
    account().signOut();
    ASSERT_TRUE(waitUntil([&] { return account().state() == ui::Account::State::Guest; }));
  }
  void signIn(const QString& name, const QString& password) {
    action("accountSignIn").trigger();
    QDialog* dialog = dialogWith("signInName");
    type(dialog, "signInName", name);
    type(dialog, "signInPassword", password);
    go(dialog);
  }
  template <class T>
  Result<T> asked(std::function<Result<T>(const SignedIn&)> question) {
    Result<T> answer = fail("no answer came");
    bool there = false;
    account().query<T>(window.get(), std::move(question),
                       [&](Result<T> told) { answer = std::move(told), there = true; });
    EXPECT_TRUE(waitUntil([&] { return there; }));
    return answer;
  }
  QStringList row(const QTableWidget& table, int index) {
    QStringList texts;
    for (int column = 0; column < table.columnCount(); ++column) texts << table.item(index, column)->text();
    return texts;
  }
  /// A class list as a file that is dropped on a window.
  void drop(QDialog* dialog, const QByteArray& list) {
    QFile file(home.filePath("list.csv"));
    ASSERT_TRUE(file.open(QFile::WriteOnly));
    file.write(list);
    file.close();
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file.fileName())});
    QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(dialog, &enter);
    QDropEvent dropped({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(dialog, &dropped);
  }

  QTemporaryDir home;
  std::unique_ptr<ui::MainWindow> window;
};

}  // namespace insonate::test
