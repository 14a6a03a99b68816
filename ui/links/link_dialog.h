// Asks for a link: its kind, host and port (or device, or file), and shows the URL that comes of it, checked while typing.
#pragma once

#include <QtCore/QString>
#include <QtWidgets/QDialog>

class QComboBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace skyseal::ui {

class LinkDialog : public QDialog
{
    Q_OBJECT

public:
    /// Starts with `url` filled in where it is a good one.
    explicit LinkDialog(const QString &url, QWidget *parent = nullptr);

    /// A well-formed URL once the dialog was accepted.
    QString url() const;

private:
    void fill(const QString &url);
    void showKind();
    void check();
    void browse();
    QString problem() const;

    QComboBox *m_kind;
    QLineEdit *m_host;
    QSpinBox *m_port;
    QLineEdit *m_path;
    QPushButton *m_browse;
    QComboBox *m_baud;
    QLabel *m_hostLabel, *m_portLabel, *m_pathLabel, *m_baudLabel;
    QLabel *m_result;
    QDialogButtonBox *m_buttons;
};

} // namespace skyseal::ui
