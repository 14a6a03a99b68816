#pragma once

#include <QtCore/QHash>
#include <QtCore/QStringList>
#include <QtWidgets/QTextBrowser>

namespace skyseal::ui {

/// A help page from resources/help, with its pictures as wide as the text. Links to other pages are followed.
class HelpPage : public QTextBrowser
{
    Q_OBJECT

public:
    /// `inserts`: see HelpDialog.
    explicit HelpPage(const QHash<QString, QString> &inserts, QWidget *parent = nullptr);

    /// `page` is a name in resources/help without its suffix.
    void open(const QString &page);
    void back();

Q_SIGNALS:
    void canGoBackChanged(bool canGoBack);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void show(const QString &page);
    void fitPictures();

    const QHash<QString, QString> m_inserts;
    QStringList m_opened; ///< the last one is shown
};

} // namespace skyseal::ui
