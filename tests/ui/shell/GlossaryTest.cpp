#include <insonate/procedure/MetricTitle.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/teaching/TeachingHere.h>
#include <insonate/train/TrainWorkspace.h>
#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/Text.h>

#include <gtest/gtest.h>
#include <window/HelpWindow.h>

#include <QLabel>
#include <QListWidget>

namespace {

using namespace insonate;

/// The lines of the help's page, as they are read there.
QStringList glossary() {
  ui::HelpWindow help(nullptr);
  help.showPage("glossary");
  return help.shownText().split('\n');
}

/// Term that a line of the list defines: "tip in image".
QString termOf(const QString& line) {
  return line.section(':', 0, 0).section(',', 0, 0);
}

TEST(Glossary, DefinesEachMetricAsItIsCountedWithItsNorms) {
  const QStringList lines = glossary();
  std::vector<Procedure> procedures;
  for (const std::string& name : procedurePresetNames()) procedures.push_back(*loadProcedure(name));
  for (const MetricDefinition& metric : metricTable()) {
    const QString unit = metric.unit == "deg" ? QString("°") : ui::qt(metric.unit);
    QString line = ui::titleOf(metric.metric) + (unit.isEmpty() ? "" : ", " + unit) + ": " + ui::qt(metric.definition);
    for (const Procedure& procedure : procedures)
      for (const MetricNorm& norm : procedure.norms)
        if (norm.metric == metric.metric)
          line += QString(" %1: novice %2, expert %3.")
                      .arg(ui::qt(procedure.title))
                      .arg(norm.novice, 0, 'g', 4)
                      .arg(norm.expert, 0, 'g', 4);
    EXPECT_TRUE(lines.contains(line)) << line.toStdString() << "\nbut\n"
                                      << lines.filter(ui::titleOf(metric.metric)).join('\n').toStdString();
  }
}

TEST(Glossary, NamesAreTheSameWhereverMetricsAreRead) {
  const auto meanings = metricMeanings();
  ASSERT_EQ(meanings.size(), std::size_t(kMetricCount));
  for (const MetricDefinition& metric : metricTable()) {
    const QString title = ui::titleOf(metric.metric);
    EXPECT_EQ(title, ui::qt(metricTitle(metric.metric)));
    EXPECT_EQ(title.left(1).toUpper() + title.mid(1), ui::qt(meanings[std::size_t(metric.metric)].title));
    for (const char* word : {"picture", "double", "nearest", "centre", "_"})
      EXPECT_FALSE(title.contains(word)) << title.toStdString();
  }
}

TEST(Glossary, DefinesEachNumberOfTrainsControls) {
  QStringList terms;
  for (const QString& line : glossary()) terms << termOf(line);
  train::TrainWorkspace train;
  auto* controls = train.findChild<QWidget*>("trainControls");
  ASSERT_TRUE(controls);
  int seen = 0;
  for (const QLabel* label : controls->findChildren<QLabel*>()) {
    const QString name = label->text();
    const bool unit = name == "mm" || name == "mmHg" || name == "/";
    if (name.isEmpty() || unit || label->property("role") == "heading") continue;
    ++seen;
    EXPECT_TRUE(terms.contains(name)) << name.toStdString();
  }
  EXPECT_GT(seen, 20);
}

TEST(Glossary, IsListedWithTheOtherPages) {
  ui::HelpWindow help(nullptr);
  help.showPage("glossary");
  auto* list = help.findChild<QListWidget*>();
  ASSERT_TRUE(list && list->currentItem());
  EXPECT_EQ(list->currentItem()->text(), "Glossary");
}

}  // namespace
