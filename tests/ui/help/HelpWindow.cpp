#include "HelpWindow.h"

#include "Workspaces.h"

#include <insonate/ui/Account.h>
#include <insonate/ui/ViewWidget.h>

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QCursor>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPixmap>
#include <QRegularExpression>
#include <QTabBar>
#include <QTextDocument>
#include <QTextDocumentFragment>
#include <algorithm>

namespace insonate::test {
namespace {

QString plain(const QString& text) {
  return Qt::mightBeRichText(text) ? QTextDocumentFragment::fromHtml(text).toPlainText() : text;
}

QStringList textsOf(const QWidget& widget) {
  if (auto* label = qobject_cast<const QLabel*>(&widget)) return {plain(label->text())};
  if (auto* button = qobject_cast<const QAbstractButton*>(&widget)) return {button->text()};
  if (auto* choice = qobject_cast<const QComboBox*>(&widget)) return {choice->currentText()};
  QStringList texts;
  if (auto* tabs = qobject_cast<const QTabBar*>(&widget))
    for (int i = 0; i < tabs->count(); ++i) texts << tabs->tabText(i);
  if (auto* header = qobject_cast<const QHeaderView*>(&widget); header && header->model())
    for (int i = 0; i < header->count(); ++i) texts << header->model()->headerData(i, header->orientation()).toString();
  return texts;
}

/// Returns what the widgets in this part say, a line each. Numbers, months and the status bar are left out, since they
/// depend on the computer and the time.
QStringList wordsOf(QWidget& root, const QRect& part) {
  static const QRegularExpression number(
      QStringLiteral("[-+]?[0-9][0-9.:/]*|\\b(Jan|Feb|Mar|Apr|May|Jun|Jul|Aug|Sep|Oct|Nov|Dec)\\b"));
  QStringList words;
  for (const QWidget* widget : root.findChildren<QWidget*>()) {
    if (widget->parentWidget()->inherits("insonate::ui::StatusStrip")) continue;
    const QRect place(widget->mapTo(&root, QPoint()), widget->size());
    if (!widget->isVisible() || widget->visibleRegion().isEmpty() || !part.contains(place.center())) continue;
    for (QString text : textsOf(*widget))
      if (text = text.replace(number, "#").simplified(); !text.isEmpty()) words << text;
  }
  return words;
}

bool write(const QString& path, const QStringList& lines) {
  QFile file(path);
  return file.open(QIODevice::WriteOnly) && file.write((lines.join('\n') + '\n').toUtf8()) > 0;
}

}  // namespace

void HelpWindow::open(const QString& workspace, QSize size) {
  window_ = std::make_unique<ui::MainWindow>(std::make_unique<ui::Account>(
      home_.filePath("people.sqlite"), StoreServices{.passwordCost = PasswordCost::Minimum}));
  app::addWorkspaces(*window_);
  window_->showWorkspace(workspace);
  window_->resize(size);
  window_->show();
  QApplication::setActiveWindow(window_.get());
  window_->openTextbook();
  settle();
}

void HelpWindow::settle() {
  QCursor::setPos(window_->mapToGlobal({5, 5}));  // views state what is under the pointer
  ASSERT_TRUE(waitFor([&] { return window_->isComplete(); })) << window_->statusText().toStdString();
  QTest::qWait(1000);  // views are told what to show a moment after their data has come
  ASSERT_TRUE(waitFor([&] {
    const auto views = window_->findChildren<ui::ViewWidget*>();
    return std::none_of(views.begin(), views.end(),
                        [](const auto* view) { return view->isVisible() && view->isDrawing(); });
  }));
}

void HelpWindow::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
  QTest::keyClick(child<ui::ViewWidget>("ultrasoundView")->focusProxy(), key, modifiers);
}

void HelpWindow::type(const char* field, const char* number) {
  auto* line = child<QLineEdit>(field);
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, number);
  QTest::keyClick(line, Qt::Key_Return);
}

QRect HelpWindow::rectOf(const QWidget& widget, const QWidget& root) {
  return {widget.mapTo(&root, QPoint()), widget.size()};
}

void HelpWindow::expectCurrent(QWidget& root, QRect part, const QString& image) {
  const QString words = QStringLiteral(INSONATE_SOURCE_DIR "/tests/ui/help/words/%1.txt").arg(image);
  const QStringList now = wordsOf(root, part);
  if (qEnvironmentVariableIsSet("INSONATE_UPDATE_HELP")) {
    QPixmap picture = root.grab(part);
    // Help shows the first steps in a column of this width.
    constexpr int kColumn_px = 580;
    if (image.startsWith("first-") && picture.width() > kColumn_px)
      picture = picture.scaledToWidth(kColumn_px, Qt::SmoothTransformation);
    EXPECT_TRUE(picture.save(QStringLiteral(INSONATE_SOURCE_DIR "/resources/help/%1.png").arg(image), "PNG"));
    EXPECT_TRUE(write(words, now));
    return;
  }
  QFile file(words);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << words.toStdString();
  const QStringList then = QString::fromUtf8(file.readAll()).trimmed().split('\n');
  EXPECT_EQ(now.join('\n').toStdString(), then.join('\n').toStdString())
      << "The window no longer says what resources/help/" << image.toStdString()
      << ".png shows. Run help_images_test with INSONATE_UPDATE_HELP=1, and look at the new image.";
}

}  // namespace insonate::test
