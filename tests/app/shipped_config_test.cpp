// The configuration files that are shipped as examples (packaging/air.conf and gateway.conf), read by their programs: as they
// are, with each of their commented-out options, and complete as to the options that a service may need.
#include "core/base/research.h"
#include "tests/support/run_program.h"
#include "tests/support/test_runner.h"

#include <QtCore/QFile>
#include <QtCore/QMap>
#include <QtCore/QRegularExpression>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include <algorithm>

using namespace skyseal::test;

namespace {

/// An example, the program that reads it, and an option that ends the program when all others were accepted, so that it opens
/// neither links nor keys.
struct ShippedConfig
{
    const char *file;
    const char *program;
    QStringList command, last;
    int status;       ///< of a run that accepts everything else
    QByteArray ended; ///< and what it complains of
};

ShippedConfig shippedConfig(bool gateway)
{
    if (gateway)
        return {"gateway.conf",
                "skyseal-cli",
                {QStringLiteral("gateway")},
                {QStringLiteral("--duration"), QStringLiteral("soon")},
                2,
                "--duration 'soon'"};
    return {"air.conf", "skyseal-air",         {}, {QStringLiteral("--identity"), QStringLiteral("/nonexistent/air.key")},
            3,          "/nonexistent/air.key"};
}

QStringList linesOf(const ShippedConfig &config)
{
    QFile file(QStringLiteral(SKYSEAL_SOURCE_DIR "/packaging/") + QLatin1String(config.file));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s is missing", config.file);
    return QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'));
}

/// The option that a commented-out line sets; empty for prose, which has a blank after the #.
QString commentedOption(const QString &line)
{
    static const QRegularExpression option(QStringLiteral("^#([a-z][a-z-]*) *="));
    return option.match(line).captured(1);
}

/// Options that are refused without others.
QStringList requiredBeside(const QString &option)
{
    static const QMap<QString, QString> required{{QStringLiteral("mqtt-ca"), QStringLiteral("mqtt")},
                                                 {QStringLiteral("mqtt-cert"), QStringLiteral("mqtt mqtt-key")},
                                                 {QStringLiteral("mqtt-key"), QStringLiteral("mqtt mqtt-cert")},
                                                 {QStringLiteral("mqtt-login"), QStringLiteral("mqtt")},
                                                 {QStringLiteral("mqtt-raw"), QStringLiteral("mqtt")},
                                                 {QStringLiteral("accept-unsigned"), QStringLiteral("vehicle-signing")}};
    return required.value(option).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

/// Options that no example needs to show, with the reason.
QMap<QString, QString> optionsElsewhere(bool gateway)
{
    const QString help = QStringLiteral("says something and ends"), once = QStringLiteral("no option of the running service"),
                  shell = QStringLiteral("a descriptor that a shell opens"), pairing = QStringLiteral("of --pair"),
                  research = QStringLiteral("for comparison only");
    QMap<QString, QString> out{{QStringLiteral("help"), help},
                               {QStringLiteral("version"), help},
                               {QStringLiteral("config"), QStringLiteral("the file itself")},
                               {QStringLiteral("passphrase-fd"), shell}};
    if (gateway) {
        out[QStringLiteral("duration")] = once;
        return out;
    }
    for (const char *option : {"signing", "send-key-in-clear", "pair", "check"})
        out[QLatin1String(option)] = once;
    for (const char *option :
         {"role", "fingerprints", "expect", "replace", "as", "pair-passphrase", "pair-passphrase-file", "pair-passphrase-fd"})
        out[QLatin1String(option)] = pairing;
    if (skyseal::kResearch) {
        for (const char *option : {"allow-research", "allow-plain", "allow-inline"})
            out[QLatin1String(option)] = research;
    }
    return out;
}

} // namespace

class ShippedConfigTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyLineIsAccepted_data();
    void everyLineIsAccepted();
    void wrongLineIsRefused_data();
    void wrongLineIsRefused();
    void everyOptionIsShown_data();
    void everyOptionIsShown();

private:
    RunResult read(const ShippedConfig &config, const QStringList &lines)
    {
        QFile file(m_folder.filePath(QLatin1String(config.file)));
        if (!file.open(QIODevice::WriteOnly | QIODevice::Truncate))
            qFatal("no file");
        file.write(lines.join(QLatin1Char('\n')).toUtf8());
        file.close();
        file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
        return runProgram(config.program,
                          config.command + QStringList{QStringLiteral("--config"), file.fileName()} + config.last);
    }

    QTemporaryDir m_folder;
};

void ShippedConfigTest::everyLineIsAccepted_data()
{
    QTest::addColumn<bool>("gateway");
    QTest::addColumn<QList<int>>("uncommented"); // lines, from 0
    for (const bool gateway : {false, true}) {
        const ShippedConfig config = shippedConfig(gateway);
        const QStringList lines = linesOf(config);
        QTest::addRow("%s as shipped", config.file) << gateway << QList<int>();
        QList<int> all;
        for (int i = 0; i < lines.size(); ++i) {
            const QString option = commentedOption(lines[i]);
            if (option.isEmpty())
                continue;
            const QStringList others = requiredBeside(option);
            QList<int> uncommented{i};
            for (int other = 0; other < lines.size(); ++other) {
                if (others.contains(commentedOption(lines[other])))
                    uncommented << other;
            }
            all << i;
            QTest::addRow("%s:%d %s", config.file, i + 1, qPrintable(lines[i])) << gateway << uncommented;
        }
        QTest::addRow("%s with all lines", config.file) << gateway << all;
    }
}

void ShippedConfigTest::everyLineIsAccepted()
{
    QFETCH(bool, gateway);
    QFETCH(QList<int>, uncommented);
    const ShippedConfig config = shippedConfig(gateway);
    QStringList lines = linesOf(config);
    for (const int line : uncommented)
        lines[line].remove(0, 1);
    const RunResult result = read(config, lines);
    QVERIFY2(result.err.contains(config.ended), result.err.constData());
    QCOMPARE(result.status, config.status);
}

void ShippedConfigTest::wrongLineIsRefused_data()
{
    QTest::addColumn<bool>("gateway");
    QTest::addColumn<QString>("line");
    QTest::addColumn<QByteArray>("said");
    QTest::newRow("agent, name") << false << QStringLiteral("max-old = 5") << QByteArray("no option is named 'max-old'");
    QTest::newRow("agent, value") << false << QStringLiteral("max-age = 0.1") << QByteArray("--max-age '0.1'");
    QTest::newRow("gateway, name") << true << QStringLiteral("metric = 1") << QByteArray("no option is named 'metric'");
    QTest::newRow("gateway, value") << true << QStringLiteral("mqtt = broker") << QByteArray("--mqtt: ");
}

/// The same way of reading finds what is wrong in a file.
void ShippedConfigTest::wrongLineIsRefused()
{
    QFETCH(bool, gateway);
    QFETCH(QString, line);
    QFETCH(QByteArray, said);
    const ShippedConfig config = shippedConfig(gateway);
    const RunResult result = read(config, linesOf(config) << line);
    QCOMPARE(result.status, 2);
    QVERIFY2(result.err.contains(said) && !result.err.contains(config.ended), result.err.constData());
}

void ShippedConfigTest::everyOptionIsShown_data()
{
    QTest::addColumn<bool>("gateway");
    QTest::newRow("skyseal-air") << false;
    QTest::newRow("skyseal-cli gateway") << true;
}

void ShippedConfigTest::everyOptionIsShown()
{
    QFETCH(bool, gateway);
    const ShippedConfig config = shippedConfig(gateway);
    const RunResult help = runProgram(config.program, config.command + QStringList{QStringLiteral("--help")});
    QCOMPARE(help.status, 0);
    static const QRegularExpression declared(QStringLiteral("^  (?:-\\w, )?--([a-z][a-z-]*)"),
                                             QRegularExpression::MultilineOption);
    QStringList options;
    for (auto found = declared.globalMatch(QString::fromUtf8(help.out)); found.hasNext();)
        options << found.next().captured(1);
    QVERIFY2(options.contains(QStringLiteral("identity")) && options.contains(QStringLiteral("config")), help.out.constData());

    const QString text = linesOf(config).join(QLatin1Char('\n'));
    const auto isShown = [&text](const QString &option) {
        const QRegularExpression line(QStringLiteral("(^|[# ])%1 = \\S").arg(option), QRegularExpression::MultilineOption);
        return line.match(text).hasMatch();
    };
    const QMap<QString, QString> elsewhere = optionsElsewhere(gateway);
    for (const QString &option : options) {
        const bool excepted = elsewhere.contains(option);
        QVERIFY2(isShown(option) != excepted,
                 qPrintable(option
                            + (excepted ? QStringLiteral(" is shown, although it is ") + elsewhere[option]
                                        : QStringLiteral(" is not shown"))));
    }
    for (const QString &option : elsewhere.keys())
        QVERIFY2(options.contains(option), qPrintable(option + QStringLiteral(" is no option")));
}

SKYSEAL_TEST(ShippedConfigTest)
#include "shipped_config_test.moc"
