#include "HelpWindow.h"

#include <insonate/embedded/help.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>

#include <QAbstractTextDocumentLayout>
#include <QDesktopServices>
#include <QHBoxLayout>
#include <QListWidget>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QUrl>

namespace insonate::ui {
namespace {

constexpr int kList_px = 200;

QString textOf(const embedded::help::File& file) {
  return qt(file.text);
}

/// The first line, without its "# ".
QString titleOf(const embedded::help::File& file) {
  return textOf(file).section(QLatin1Char('\n'), 0, 0).mid(2);
}

/// The anchor by which links name a heading: lower case, "-" for spaces, without other signs. Qt's Markdown makes none.
QString anchorOf(const QString& heading) {
  QString anchor;
  for (const QChar one : heading.toLower())
    if (one.isLetterOrNumber() || one == QLatin1Char('-'))
      anchor += one;
    else if (one.isSpace())
      anchor += QLatin1Char('-');
  return anchor;
}

}  // namespace

HelpWindow::HelpWindow(QWidget* parent) : QDialog(parent), list_(new QListWidget), page_(new QTextBrowser) {
  setWindowTitle(tr("Insonate: help"));
  list_->setFixedWidth(kList_px);
  list_->setSpacing(3);
  list_->setAccessibleName(tr("Help pages"));
  for (const auto& file : embedded::help::files()) list_->addItem(titleOf(file));
  list_->addItem(tr("Keys"));
  page_->setOpenLinks(false);
  page_->setSearchPaths({QStringLiteral(":/insonate/help")});
  page_->setAccessibleName(tr("Help page"));
  page_->document()->setDefaultStyleSheet(
      QStringLiteral("th { text-align: left; color: %1 } td { padding-right: 24px; padding-bottom: 6px }")
          .arg(toQColor(views::theme::kQuiet).name()));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(kGap, kGap, kGap, kGap);
  row->setSpacing(kGap);
  row->addWidget(list_);
  row->addWidget(page_, 1);
  connect(list_, &QListWidget::currentRowChanged, this, &HelpWindow::showRow);
  connect(page_, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
    if (!link.scheme().isEmpty()) return void(QDesktopServices::openUrl(link));
    if (!link.path().isEmpty()) showPage(link.path());
    if (link.hasFragment()) showHeading(link.fragment());
  });
  resize(880, 620);
}

void HelpWindow::setShortcuts(const std::vector<ShortcutGroup>& groups) {
  keys_ = QStringLiteral("<h1>%1</h1>").arg(tr("Keys"));
  for (const ShortcutGroup& group : groups) {
    if (group.shortcuts.empty()) continue;
    keys_ += QStringLiteral("<h3>%1</h3><table>").arg(group.place.toHtmlEscaped());
    for (const Shortcut& one : group.shortcuts)
      keys_ += QStringLiteral("<tr><td width=\"240\"><b>%1</b></td><td>%2</td></tr>")
                   .arg(one.keys.toHtmlEscaped(), one.does.toHtmlEscaped());
    keys_ += QStringLiteral("</table>");
  }
}

void HelpWindow::showRow(int row) {
  const auto files = embedded::help::files();
  if (row >= 0 && row < int(files.size()))
    page_->setMarkdown(textOf(files[std::size_t(row)]));
  else
    page_->setHtml(keys_);
}

void HelpWindow::showPage(const QString& name) {
  int row = 0, shown = 0;
  for (const auto& file : embedded::help::files()) {
    if (name == QLatin1String(file.name.data(), int(file.name.size()))) shown = row;
    ++row;
  }
  list_->setCurrentRow(shown);
  showRow(shown);
  show();
  raise();
}

void HelpWindow::showHeading(const QString& anchor) {
  const QTextDocument& document = *page_->document();
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
    if (block.blockFormat().headingLevel() > 0 && anchorOf(block.text()) == anchor)
      return page_->verticalScrollBar()->setValue(
          int(document.documentLayout()->blockBoundingRect(block).top() - kGap));
}

void HelpWindow::showKeys() {
  list_->setCurrentRow(list_->count() - 1);
  showRow(list_->count() - 1);
  show();
  raise();
}

QString HelpWindow::shownText() const {
  return page_->toPlainText();
}

}  // namespace insonate::ui
