#include "Waiting.h"

#include <gtest/gtest.h>
#include <support/SmallCase.h>

#include <QTemporaryDir>
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

}  // namespace insonate::test
