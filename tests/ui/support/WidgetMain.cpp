#include <insonate/ui/FieldEventFilter.h>
#include <insonate/ui/FileDialogTraces.h>
#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ViewWidget.h>

#include <gtest/gtest.h>

#include <QApplication>
#include <QTemporaryDir>
#include <chrono>
#include <memory>

namespace {

/// Comes after the screen, which registers itself before main(), and goes before it. Settings, cache and the user's
/// data are a folder of this process.
class Application : public testing::Environment {
 public:
  void SetUp() override {
    if (testing::Test::IsSkipped()) return;  // There is no screen.
    ASSERT_TRUE(home_.isValid());
    qputenv("XDG_CONFIG_HOME", (home_.path() + QStringLiteral("/config")).toUtf8());
    qputenv("XDG_CACHE_HOME", (home_.path() + QStringLiteral("/cache")).toUtf8());
    qputenv("XDG_DATA_HOME", (home_.path() + QStringLiteral("/data")).toUtf8());
    qputenv("QT_QPA_PLATFORM", "xcb");
    insonate::ui::prepareGraphics();
    application_ = std::make_unique<QApplication>(count_, arguments_);
    QCoreApplication::setOrganizationName(QStringLiteral("Insonate"));
    QCoreApplication::setApplicationName(QStringLiteral("widget_test"));
    insonate::ui::applyTheme(*application_);
    insonate::ui::removeFileDialogTraces(*application_);
    insonate::ui::filterFieldEvents(*application_);
  }
  void TearDown() override {
    // As at the end of the program: nothing goes on while the process goes.
    EXPECT_TRUE(insonate::ui::waitForJobs(std::chrono::seconds(20)));
    application_.reset();
  }

 private:
  QTemporaryDir home_;
  char name_[12] = "widget_test";
  char* arguments_[2] = {name_, nullptr};
  int count_ = 1;
  std::unique_ptr<QApplication> application_;
};

/// A fatal failure ends the test also from within what it calls: a wait that was in vain is not gone on from.
class EndsTheTest : public testing::EmptyTestEventListener {
  void OnTestPartResult(const testing::TestPartResult& result) override {
    if (result.type() == testing::TestPartResult::kFatalFailure) throw testing::AssertionException(result);
  }
};

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  testing::AddGlobalTestEnvironment(new Application);
  testing::UnitTest::GetInstance()->listeners().Append(new EndsTheTest);  // last, after what prints
  return RUN_ALL_TESTS();
}
