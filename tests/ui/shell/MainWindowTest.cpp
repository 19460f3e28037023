#include "Waiting.h"

#include <insonate/cases/DicomWriter.h>
#include <insonate/ui/EmptyWorkspace.h>
#include <insonate/ui/ErrorPanel.h>
#include <insonate/ui/MainWindow.h>
#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Workspace.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDropEvent>
#include <QFile>
#include <QImage>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QScrollBar>
#include <QSettings>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QToolButton>
#include <QUrl>
#include <QtTest/QTest>
#include <algorithm>
#include <memory>

namespace {

using namespace insonate;
using test::waitUntil;

class FakeWorkspace final : public ui::Workspace {
 public:
  FakeWorkspace() { commands().addListed("Space", "freeze the picture"); }
  void setCase(std::shared_ptr<const PatientCase> patient) override {
    shown = std::move(patient);
    Q_EMIT readyChanged();
  }
  void setOpeningText(const QString& what) override { opening = what; }
  QString statusText() const override { return shown ? "Move the probe." : "Open a case."; }
  QString engineText() const override { return "processor   62 images/s"; }
  QString engineNote() const override { return "There is no graphics card."; }
  void stop() override { stopped = true; }
  void keyPressEvent(QKeyEvent* event) override {
    if (event->key() == Qt::Key_Space)
      ++spaces;
    else
      ui::Workspace::keyPressEvent(event);
  }
  void saveLayout(QSettings& settings) const override { settings.setValue("probe", probe); }
  void restoreLayout(QSettings& settings) override { probe = settings.value("probe", probe).toString(); }

  std::shared_ptr<const PatientCase> shown;
  QString probe = "linear", opening;
  bool stopped = false;
  int spaces = 0;
};

struct Window {
  Window() {
    window.addWorkspace("prepare", "Prepare", "prepare", new ui::EmptyWorkspace({"prepare", "Prepare", {}, {}, {}}));
    window.addWorkspace("train", "Train", "train", train);
    window.addWorkspace("review", "Review", "review", new ui::EmptyWorkspace({"review", "Nothing yet", {}, {}, {}}));
    window.restoreLayout();
    window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
    QApplication::setActiveWindow(&window);  // without a window manager, activation may come later or never
  }
  FakeWorkspace* train = new FakeWorkspace;
  ui::MainWindow window;
};

class MainWindow : public testing::Test {
 protected:
  void SetUp() override { QSettings().clear(); }

  void drop(ui::MainWindow& window, const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter({300, 300}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&window, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent event({300, 300}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&window, &event);
  }

  QTemporaryDir home;
};

TEST_F(MainWindow, ChangesWorkspacesByKeyboard) {
  Window w;
  EXPECT_EQ(w.window.currentId(), "prepare");
  QTest::keyClick(&w.window, Qt::Key_2, Qt::ControlModifier);
  EXPECT_EQ(w.window.currentId(), "train");
  EXPECT_EQ(w.window.statusText(), "Open a case.");
  QTest::keyClick(&w.window, Qt::Key_3, Qt::ControlModifier);
  EXPECT_EQ(w.window.currentId(), "review");
  EXPECT_FALSE(w.window.showWorkspace("kitchen"));
}

TEST_F(MainWindow, TabReachesEverythingAndArrowsTheNextWorkspace) {
  Window w;
  QStringList reached;
  QTest::keyClick(&w.window, Qt::Key_Tab);
  for (int i = 0; i < 10 && w.window.focusWidget(); ++i) {
    reached << w.window.focusWidget()->accessibleName();
    QTest::keyClick(w.window.focusWidget(), Qt::Key_Tab);
  }
  for (const char* name : {"Prepare", "Case menu", "Help"})
    EXPECT_TRUE(reached.contains(name)) << name << " in " << reached.join(", ").toStdString();
  QWidget* tab = nullptr;
  for (auto* button : w.window.findChildren<QToolButton*>())
    if (button->accessibleName() == "Prepare") tab = button;
  ASSERT_TRUE(tab);
  tab->setFocus();
  QTest::keyClick(tab, Qt::Key_Right);
  EXPECT_EQ(w.window.currentId(), "train");
}

TEST_F(MainWindow, OpensADroppedCaseAndGivesItToWorkspaces) {
  Window w;
  w.window.showWorkspace("train");
  EXPECT_FALSE(w.window.isReady());
  drop(w.window, test::writtenSmallCase(home, "block"));
  ASSERT_TRUE(waitUntil([&] { return w.window.isReady(); }));
  EXPECT_EQ(w.train->shown->manifest.title, "Small block");
  EXPECT_EQ(w.window.caseTitle(), "Small block");
  EXPECT_EQ(w.window.statusText(), "Opened Small block.");
  const QList<QLabel*> labels = w.window.findChildren<QLabel*>();
  const auto engine = std::ranges::find(labels, QString("processor   62 images/s"), &QLabel::text);
  ASSERT_NE(engine, labels.end());
  EXPECT_TRUE((*engine)->toolTip().contains("There is no graphics card.")) << "why this engine";
}

TEST_F(MainWindow, SaysTheSameEverywhereWhileTheFirstCaseIsBeingOpened) {
  Window w;
  EXPECT_EQ(w.window.caseTitle(), "no case");
  w.window.open(test::writtenSmallCase(home, "block"));
  EXPECT_EQ(w.window.caseTitle(), "Opening block ...");
  EXPECT_EQ(w.window.windowTitle(), "Opening block ... - Insonate");
  EXPECT_EQ(w.train->opening, "Opening block");
  w.window.tasks().cancel();
  EXPECT_EQ(w.window.caseTitle(), "no case");
  EXPECT_EQ(w.window.windowTitle(), "Insonate");
  EXPECT_EQ(w.train->opening, "");
  w.window.open(home.filePath("block"));
  ASSERT_TRUE(waitUntil([&] { return w.train->shown != nullptr; }));
  EXPECT_EQ(w.window.windowTitle(), "Small block - Insonate");
  EXPECT_EQ(w.train->opening, "");
  w.window.openTextbook();
  EXPECT_EQ(w.window.caseTitle(), "Small block") << "which is what is on the screen";
  w.window.tasks().cancel();
}

TEST_F(MainWindow, SaysThatThereIsNothingUnderAPath) {
  Window w;
  w.window.open(home.filePath("nothing"));
  EXPECT_TRUE(w.window.errors().isVisible());
  EXPECT_TRUE(w.window.errors().message().contains("There is no file or folder"));
}

TEST_F(MainWindow, SaysWhyADroppedFolderDoesNotOpenAndKeepsTheCase) {
  Window w;
  w.window.open(test::writtenSmallCase(home, "block"));
  ASSERT_TRUE(waitUntil([&] { return w.window.current().patient != nullptr; }));
  QDir(home.path()).mkdir("empty");
  drop(w.window, home.filePath("empty"));
  ASSERT_TRUE(waitUntil([&] { return w.window.errors().isVisible(); }));
  EXPECT_TRUE(w.window.errors().message().contains("empty")) << w.window.errors().message().toStdString();
  EXPECT_EQ(w.window.caseTitle(), "Small block");
  QTest::keyClick(&w.window, Qt::Key_Escape);
  EXPECT_FALSE(w.window.errors().isVisible());
}

TEST_F(MainWindow, AboutSaysWhatItIsAndIsNot) {
  Window w;
  for (QAction* action : w.window.actions())
    if (action->text() == "About Insonate") action->trigger();
  auto* dialog = w.window.findChild<QDialog*>();
  ASSERT_TRUE(dialog);
  const QString text = dialog->findChild<QTextBrowser*>()->toPlainText();
  for (const char* said : {"not a medical device", "Apache License 2.0", "Qt 5", "LGPL 3", "VTK", "ITK", "OpenCV"})
    EXPECT_TRUE(text.contains(said)) << said;
  QTest::keyClick(dialog, Qt::Key_Escape);
  EXPECT_TRUE(waitUntil([&] { return !w.window.findChild<QDialog*>(); }));
}

TEST_F(MainWindow, TakesADroppedDicomFolder) {
  Window w;
  const QString folder = home.filePath("dicom");
  ASSERT_TRUE(writeDicomSeries(test::smallCase().ct, folder.toStdString(), {.seed = "dropped"}));
  drop(w.window, folder);
  ASSERT_TRUE(waitUntil([&] { return w.window.findChild<QDialog*>() != nullptr; }));
  w.window.findChild<QDialog*>()->accept();
  EXPECT_TRUE(waitUntil([&] { return w.window.current().patient != nullptr; }));
  EXPECT_EQ(w.window.caseTitle(), "Imported CT (not saved)");
  test::answerFileDialog(w.window, home.filePath("short neck"));
  w.window.saveCase();
  EXPECT_TRUE(waitUntil([&] { return w.window.caseTitle() == "short neck"; })) << w.window.caseTitle().toStdString();
}

TEST_F(MainWindow, SaysWhatToDoWithADroppedPictureOrNonsense) {
  Window w;
  w.window.open(test::writtenSmallCase(home, "block"));
  ASSERT_TRUE(waitUntil([&] { return w.window.current().patient != nullptr; }));
  QImage picture(80, 80, QImage::Format_RGB32);
  picture.fill(Qt::gray);
  ASSERT_TRUE(picture.save(home.filePath("capture.png")));
  QFile notes(home.filePath("notes.txt"));
  ASSERT_TRUE(notes.open(QFile::WriteOnly) && notes.write("no CT") > 0);
  notes.close();
  for (const char* name : {"capture.png", "notes.txt"}) {
    drop(w.window, home.filePath(name));
    ASSERT_TRUE(waitUntil([&] { return w.window.errors().isVisible(); })) << name;
    EXPECT_TRUE(w.window.errors().message().contains(name)) << w.window.errors().message().toStdString();
    QStringList said;
    for (const auto* label : w.window.errors().findChildren<QLabel*>()) said << label->text();
    EXPECT_EQ(said.join(' ').contains("Fit probe geometry to an image"), QString(name).endsWith("png"))
        << said.join(' ').toStdString();
    QTest::keyClick(&w.window, Qt::Key_Escape);
  }
}

TEST_F(MainWindow, TakesNothingButFiles) {
  Window w;
  QMimeData words, far;
  words.setText("no file");
  far.setUrls({QUrl("https://example.org/case")});
  for (QMimeData* data : {&words, &far}) {
    QDragEnterEvent enter({300, 300}, Qt::CopyAction, data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&w.window, &enter);
    EXPECT_FALSE(enter.isAccepted());
    QDropEvent event({300, 300}, Qt::CopyAction, data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&w.window, &event);
  }
  EXPECT_FALSE(w.window.tasks().isRunning());
  EXPECT_FALSE(w.window.errors().isVisible());
}

TEST_F(MainWindow, EscapeCancelsWhatIsBeingDone) {
  Window w;
  w.window.openTextbook();
  EXPECT_TRUE(waitUntil([&] { return w.window.tasks().isVisible(); }));
  QTest::qWait(100);
  QTest::keyClick(&w.window, Qt::Key_Escape);
  EXPECT_FALSE(w.window.tasks().isRunning());
  EXPECT_EQ(w.window.statusText(), "Canceled; nothing was changed.");
  EXPECT_TRUE(ui::waitForJobs(std::chrono::milliseconds(1000)));
}

TEST_F(MainWindow, NothingMovesWhileALongJobShows) {
  Window w;
  QApplication::processEvents();
  const QRect before(w.train->parentWidget()->mapTo(&w.window, QPoint()), w.train->parentWidget()->size());
  w.window.openTextbook();
  ASSERT_TRUE(waitUntil([&] { return w.window.tasks().isVisible(); }));
  QApplication::processEvents();
  EXPECT_EQ(QRect(w.train->parentWidget()->mapTo(&w.window, QPoint()), w.train->parentWidget()->size()), before);
  w.window.tasks().cancel();
  EXPECT_TRUE(ui::waitForJobs(std::chrono::milliseconds(1000)));
}

TEST_F(MainWindow, RemembersWorkspaceLayoutAndRecentCases) {
  {
    Window w;
    w.window.showWorkspace("review");
    w.train->probe = "phased";
    w.window.open(test::writtenSmallCase(home, "block"));
    ASSERT_TRUE(waitUntil([&] { return w.window.current().patient != nullptr; }));
    w.window.resize(1100, 700);
    w.window.close();
  }
  Window w;
  EXPECT_EQ(w.window.currentId(), "review");
  EXPECT_EQ(w.train->probe, "phased");
  EXPECT_EQ(w.window.size(), QSize(1100, 700));
  QMenu* recent = nullptr;
  for (auto* menu : w.window.findChildren<QMenu*>())
    if (menu->title() == "Recent") recent = menu;
  ASSERT_TRUE(recent);
  Q_EMIT recent->aboutToShow();
  ASSERT_FALSE(recent->actions().isEmpty());
  EXPECT_EQ(recent->actions().first()->text(), "Small block");
  recent->actions().first()->trigger();
  EXPECT_TRUE(waitUntil([&] { return w.train->shown != nullptr; }));
}

TEST_F(MainWindow, ListsAllKeysUnderTheQuestionMark) {
  Window w;
  QTest::keyClick(&w.window, Qt::Key_Question);
  auto* page = w.window.findChild<QTextBrowser*>();
  ASSERT_TRUE(page);
  const QString text = page->toPlainText();
  for (const char* said : {"Ctrl+2", "Space", "freeze the picture", "Esc", "F1"})
    EXPECT_TRUE(text.contains(said)) << said;
  w.window.showWorkspace("train");
  QTest::keyClick(&w.window, Qt::Key_Question);
  const QString there = page->toPlainText();
  EXPECT_LT(there.indexOf("freeze the picture"), there.indexOf("Everywhere")) << "first what can be done here";
  EXPECT_GT(text.indexOf("freeze the picture"), text.indexOf("Everywhere"));
  QTest::keyClick(&w.window, Qt::Key_F1);
  EXPECT_TRUE(page->toPlainText().contains("Getting started"));
}

TEST_F(MainWindow, GettingStartedIsThePageOfTheWorkspaceForAGuest) {
  Window w;
  const auto title = [&] {
    QTest::keyClick(&w.window, Qt::Key_F1, Qt::ShiftModifier);
    return w.window.findChild<QTextBrowser*>()->document()->firstBlock().text();
  };
  EXPECT_EQ(title(), "Your first case");
  w.window.showWorkspace("train");
  EXPECT_EQ(title(), "Your first central line");
  w.window.showWorkspace("review");
  EXPECT_EQ(title(), "Your first central line") << "a guest has no class";
}

TEST_F(MainWindow, ALinkInsideAHelpPageScrollsToItsHeading) {
  Window w;
  QTest::keyClick(&w.window, Qt::Key_F1);
  auto* page = w.window.findChild<QTextBrowser*>();
  Q_EMIT page->anchorClicked(QUrl("site"));
  const QString title = page->document()->firstBlock().text();
  ASSERT_TRUE(waitUntil([&] { return page->verticalScrollBar()->maximum() > 1000; }));
  Q_EMIT page->anchorClicked(QUrl("#back-up"));
  EXPECT_EQ(page->document()->firstBlock().text(), title) << "the page stays";
  EXPECT_EQ(page->cursorForPosition({20, 20}).block().text(), "Back up");
}

TEST_F(MainWindow, TheHelpFollowsItsLinksAndHasItsImages) {
  Window w;
  w.window.showWorkspace("train");
  QTest::keyClick(&w.window, Qt::Key_F1, Qt::ShiftModifier);
  auto* page = w.window.findChild<QTextBrowser*>();
  int images = 0;
  QStringList links;
  for (QTextBlock block = page->document()->begin(); block.isValid(); block = block.next())
    for (auto it = block.begin(); !it.atEnd(); ++it) {
      const QTextCharFormat format = it.fragment().charFormat();
      if (format.isAnchor()) links << format.anchorHref();
      if (!format.isImageFormat()) continue;
      ++images;
      const QString name = format.toImageFormat().name();
      const auto image = page->document()->resource(QTextDocument::ImageResource, name).value<QImage>();
      EXPECT_FALSE(image.isNull()) << name.toStdString();
    }
  EXPECT_EQ(images, 3);
  EXPECT_TRUE(waitUntil([&] { return page->verticalScrollBar()->maximum() > 0; }));
  EXPECT_EQ(page->horizontalScrollBar()->maximum(), 0) << "the images are not wider than the page";
  ASSERT_TRUE(links.contains("glossary")) << links.join(", ").toStdString();
  Q_EMIT page->anchorClicked(QUrl("glossary"));
  EXPECT_EQ(page->document()->firstBlock().text(), "Glossary");
}

TEST_F(MainWindow, AClickOnHelpLeavesTheKeyboardToTheImage) {
  Window w;
  w.window.showWorkspace("train");
  w.train->setFocusPolicy(Qt::StrongFocus);
  w.train->setFocus();
  for (auto* button : w.window.findChildren<QToolButton*>())
    if (button->accessibleName() == "Help") QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(w.window.focusWidget(), w.train);
}

TEST_F(MainWindow, ClosesWhileACaseIsBeingMade) {
  auto w = std::make_unique<Window>();
  w->window.openTextbook();
  QTest::qWait(50);
  EXPECT_TRUE(w->window.close());
  EXPECT_TRUE(w->train->stopped);
  EXPECT_FALSE(w->window.isVisible());
  w.reset();
  EXPECT_TRUE(ui::waitForJobs(std::chrono::milliseconds(1000)));
}

TEST_F(MainWindow, GoesWhileACaseIsBeingRead) {
  auto w = std::make_unique<Window>();
  w->window.open(test::writtenSmallCase(home, "block"));
  w.reset();
  EXPECT_TRUE(ui::waitForJobs(std::chrono::milliseconds(5000)));
}

TEST_F(MainWindow, KeysReachTheWorkspaceWhereverTheKeyboardIs) {
  Window w;
  w.window.showWorkspace("train");
  w.window.setFocus();
  QTest::keyClick(&w.window, Qt::Key_Space);
  EXPECT_EQ(w.train->spaces, 1);
  w.train->setFocusPolicy(Qt::StrongFocus);
  w.train->setFocus();
  QTest::keyClick(w.train, Qt::Key_Space);
  EXPECT_EQ(w.train->spaces, 2) << "once";
  QTest::keyClick(w.train, Qt::Key_X);
  QTest::keyClick(&w.window, Qt::Key_X);
}

TEST_F(MainWindow, OffersToOpenTheFolderOfWhatWasWritten) {
  Window w;
  w.window.showWorkspace("train");
  Q_EMIT w.train->written("Picture saved as a<b>.png.", home.path());
  EXPECT_EQ(w.window.statusText(), "Picture saved as a<b>.png.");
  QLabel* link = nullptr;
  for (auto* label : w.window.findChildren<QLabel*>())
    if (label->text().contains("Open folder")) link = label;
  ASSERT_TRUE(link);
  EXPECT_TRUE(link->focusPolicy() & Qt::TabFocus) << "the link is reached by keyboard";
  EXPECT_TRUE(link->text().contains("a&lt;b&gt;"));
  EXPECT_TRUE(link->toolTip().contains(home.path()));
}

TEST_F(MainWindow, ASentenceWithoutRoomEndsInAnEllipsisAndIsWholeInTheTooltip) {
  Window w;
  const QString sentence = QString("There is no case.json: the case has no title. ").repeated(4).trimmed();
  w.window.resize(700, 500);
  Q_EMIT w.train->written(sentence, {});
  QLabel* line = nullptr;
  for (auto* label : w.window.findChildren<QLabel*>())
    if (label->toolTip() == sentence) line = label;
  ASSERT_TRUE(line);
  const auto fits = [line] { return line->fontMetrics().horizontalAdvance(line->text()) <= line->width(); };
  EXPECT_TRUE(waitUntil([&] { return line->text().endsWith(QChar(0x2026)) && fits(); })) << line->text().toStdString();
  EXPECT_EQ(w.window.statusText(), sentence);
  w.window.resize(1800, 500);
  EXPECT_TRUE(waitUntil([&] { return line->text() == sentence; })) << line->text().toStdString();
}

TEST_F(MainWindow, ListsWhatAWorkspaceShowsUnderView) {
  Window w;
  auto* action = new QAction("Grid", w.train);
  w.train->addAction(action);
  QMenu* view = nullptr;
  for (auto* button : w.window.findChildren<QToolButton*>())
    if (button->accessibleName() == "View menu") view = button->menu();
  ASSERT_TRUE(view);
  w.window.showWorkspace("train");
  Q_EMIT view->aboutToShow();
  EXPECT_TRUE(view->actions().contains(action));
  w.window.showWorkspace("review");
  Q_EMIT view->aboutToShow();
  EXPECT_FALSE(view->actions().contains(action));
}

TEST_F(MainWindow, ShowsWhatAWorkspaceSays) {
  Window w;
  w.window.showWorkspace("train");
  Q_EMIT w.train->failed("The scene does not fit into memory.", "Choose a smaller depth.", "4 GiB");
  EXPECT_EQ(w.window.errors().message(), "The scene does not fit into memory. Choose a smaller depth.");
  auto made = std::make_shared<PatientCase>();
  made->manifest.title = "Edited";
  Q_EMIT w.train->caseMade(made);
  EXPECT_EQ(w.window.caseTitle(), "Edited (not saved)");
}

}  // namespace
