#include "Waiting.h"

#include <gtest/gtest.h>
#include <support/SmallCase.h>

#include <QFileDialog>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTimer>
#include <QtTest/QTest>

namespace insonate::test {

bool waitUntil(const std::function<bool()>& condition, int longest_ms) {
  return QTest::qWaitFor(condition, longest_ms);
}

QString writtenSmallCase(const QTemporaryDir& home, const QString& name) {
  const QString folder = home.filePath(name);
  const auto written = writeCase(smallCase(), folder.toStdString());
  EXPECT_TRUE(written) << written.error().message;
  return folder;
}

void answerFileDialog(QWidget& window, const QString& name) {
  auto* looking = new QTimer(&window);
  QObject::connect(looking, &QTimer::timeout, &window, [looking, &window, name] {
    auto* dialog = window.findChild<QFileDialog*>();
    if (!dialog || !dialog->isVisible()) return;
    looking->deleteLater();
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(name);
    QMetaObject::invokeMethod(dialog, "accept");
  });
  looking->start(20);
}

}  // namespace insonate::test
