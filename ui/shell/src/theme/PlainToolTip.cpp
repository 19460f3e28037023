#include <insonate/ui/PlainToolTip.h>

#include <QStringList>

namespace insonate::ui {
namespace {

constexpr int kColumns = 90, kMost = 2000;

/// Breaks at spaces; within a word only if it is longer than a line.
QStringList wrapped(QString line) {
  QStringList lines;
  while (line.size() > kColumns) {
    const int space = line.lastIndexOf(QLatin1Char(' '), kColumns);
    lines << line.left(space > 0 ? space : kColumns);
    line.remove(0, space > 0 ? space + 1 : kColumns);
  }
  return lines << line;
}

}  // namespace

QString plainToolTip(const QString& text) {
  QStringList lines;
  for (const QString& line : text.left(kMost).split(QLatin1Char('\n'))) lines << wrapped(line);
  if (text.size() > kMost) lines.back() += QStringLiteral(" ...");
  return lines.join(QLatin1Char('\n'));
}

QString plainCaption(const QString& text) {
  const QString line = text.left(kMost).simplified();
  QString caption = line.size() > kColumns ? line.left(kColumns) + QStringLiteral(" ...") : line;
  return caption.replace(QLatin1Char('&'), QStringLiteral("&&"));
}

}  // namespace insonate::ui
