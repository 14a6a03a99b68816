// A figure as skyseal-figures writes it to PDF: 88 mm wide, with text of 7 points and more, by the file itself.
#include "core/experiment/forest_chart.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QRegularExpression>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <cmath>

using namespace skyseal;
using namespace skyseal::test;

namespace {

constexpr double kPointsPerMillimetre = 72 / 25.4;

/// The contents of the pages: everything in the file that is compressed and has operators of text.
QList<QByteArray> pageContentsOf(const QByteArray &pdf)
{
    QList<QByteArray> out;
    for (qsizetype at = pdf.indexOf("stream\n"); at >= 0; at = pdf.indexOf("stream\n", at + 7)) {
        if (at >= 3 && pdf.mid(at - 3, 3) == "end")
            continue;
        const QByteArray packed = pdf.mid(at + 7, pdf.indexOf("endstream", at) - at - 7);
        if (!packed.startsWith('\x78'))
            continue;                                                               // not by zlib
        const QByteArray plain = qUncompress(QByteArray("\0\x10\0\0", 4) + packed); // with a size to begin with, as Qt wants
        if (plain.contains(" Tf"))
            out << plain;
    }
    return out;
}

/// How many points a length of 1 upwards is under the matrix: only its linear part matters.
struct Scale
{
    double a = 1, b = 0, c = 0, d = 1;
    Scale within(const Scale &outer) const
    {
        return {a * outer.a + b * outer.c, a * outer.b + b * outer.d, c * outer.a + d * outer.c, c * outer.b + d * outer.d};
    }
    double height() const { return std::hypot(c, d); }
};

/// Sizes of all texts in points.
QList<double> textSizes(const QByteArray &content)
{
    QList<double> out;
    QList<Scale> saved;
    Scale now, text;
    double font = 0;
    QList<QByteArray> operands;
    for (const QByteArray &word : content.simplified().split(' ')) {
        const auto number = [&](qsizetype back) { return operands.value(operands.size() - back).toDouble(); };
        const Scale matrix{number(6), number(5), number(4), number(3)};
        if (word == "q")
            saved << now;
        else if (word == "Q" && !saved.isEmpty())
            now = saved.takeLast();
        else if (word == "cm")
            now = matrix.within(now);
        else if (word == "BT")
            text = {};
        else if (word == "Tm")
            text = matrix;
        else if (word == "Tf")
            font = number(1);
        else if (word == "Tj" || word == "TJ")
            out << font * text.within(now).height();
        else {
            operands << word;
            continue;
        }
        operands.clear();
    }
    return out;
}

} // namespace

class FigurePdfTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void figureIsAColumnWide();
};

void FigurePdfTest::figureIsAColumnWide()
{
    experiment::ForestChart chart;
    chart.title = "CPU time per frame, station";
    chart.subtitle = "link: clean; load: natural";
    chart.legend = "95 % intervals";
    chart.axis = "ratio to plain MAVLink";
    chart.margin = 0.03;
    for (const char *arm : {"chacha20-poly1305", "aes-256-gcm", "rc4 (insecure)"})
        chart.rows.push_back({arm, 1.2, 1.1, 1.3});
    QTemporaryDir folder;
    const QString figure = folder.filePath(QStringLiteral("figure.svg"));
    QFile file(figure);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(svg(chart)));
    file.close();
    const RunResult drawn = runProgram("skyseal-figures", {figure}, {}, 60000);
    QVERIFY2(drawn.status == 0, drawn.err.constData());
    QFile written(folder.filePath(QStringLiteral("figure.pdf")));
    QVERIFY(written.open(QIODevice::ReadOnly));
    const QByteArray pdf = written.readAll();
    static const QRegularExpression kBox(QStringLiteral("/MediaBox \\[\\s*0 0 ([0-9.]+) ([0-9.]+)\\s*\\]"));
    const QRegularExpressionMatch box = kBox.match(QString::fromLatin1(pdf));
    QVERIFY(box.hasMatch());
    const double width = box.captured(1).toDouble() / kPointsPerMillimetre;
    QVERIFY2(std::abs(width - 88) < 0.3, qPrintable(QString::number(width)));
    QList<double> sizes;
    for (const QByteArray &content : pageContentsOf(pdf))
        sizes << textSizes(content);
    QVERIFY2(sizes.size() >= 10, qPrintable(QString::number(sizes.size())));
    const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
    QVERIFY2(*least >= 7 && *most < 9, qPrintable(QStringLiteral("%1 to %2 pt").arg(*least).arg(*most)));
}

SKYSEAL_TEST(FigurePdfTest)
#include "figure_pdf_test.moc"
