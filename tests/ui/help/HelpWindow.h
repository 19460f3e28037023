#pragma once

#include <insonate/ui/MainWindow.h>

#include <gtest/gtest.h>
#include <support/TestData.h>
#include <ui/support/Patience.h>

#include <QRect>
#include <QStringList>
#include <QTemporaryDir>
#include <QTest>
#include <functional>
#include <memory>

namespace insonate::test {

/// The whole window on the built-in neck, as the images of the README and the help show it.
class HelpWindow : public testing::Test {
 protected:
  void TearDown() override { window_.reset(); }

  /// Opens the window in device-independent pixels with a store of people in a file, and waits until it shows the
  /// built-in neck.
  void open(const QString& workspace, QSize size);
  bool waitFor(const std::function<bool()>& done) { return QTest::qWaitFor(done, 3 * kPatience_ms); }
  /// Waits until nothing in the window is being computed or drawn.
  void settle();
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
  void type(const char* field, const char* number);

  template <class T>
  T* child(const char* name) {
    T* found = window_->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  /// Returns the rectangle of a widget in `root`.
  static QRect rectOf(const QWidget& widget, const QWidget& root);

  /// Checks that the words of the widgets within `part` of `root` are those of the image in resources/help. With
  /// INSONATE_UPDATE_HELP set, writes the image and its words instead.
  static void expectCurrent(QWidget& root, QRect part, const QString& image);

  QTemporaryDir home_;
  std::unique_ptr<ui::MainWindow> window_;
};

}  // namespace insonate::test
