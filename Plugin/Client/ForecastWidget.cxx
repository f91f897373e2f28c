// SPDX-License-Identifier: BSD-3-Clause
#include "ForecastWidget.h"

#include "Forecast.h"

#include "pqCoreUtilities.h"
#include "vtkCommand.h"
#include "vtkSMProperty.h"
#include "vtkSMProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"

#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

/// Three digits that count, with commas.
QString Round(double number)
{
  const double digit =
    std::pow(10., std::max(0., std::floor(std::log10(std::max(1., number))) - 2.));
  return QLocale(QLocale::English).toString(digit * std::round(number / digit), 'f', 0);
}

QString Size(double bytes)
{
  return bytes < 1e9 ? Round(std::ceil(bytes / 1e6)) + " MB"
                     : QString::number(bytes / 1e9, 'f', 1) + " GB";
}

}

ForecastWidget::ForecastWidget(vtkSMProxy* proxy, vtkSMProperty*, QWidget* parent)
  : pqPropertyWidget(proxy, parent)
  , Text(new QLabel(this))
{
  this->Text->setWordWrap(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(this->Text);
  for (const std::string& name : GetForetellingProperties())
  {
    if (auto* changed = proxy->GetProperty(name.c_str()))
    {
      pqCoreUtilities::connect(changed, vtkCommand::ModifiedEvent, this, SLOT(tell()));
      pqCoreUtilities::connect(
        changed, vtkCommand::UncheckedPropertyModifiedEvent, this, SLOT(tell()));
    }
  }
  this->tell();
}

void ForecastWidget::tell()
{
  const Forecast forecast = Foretell(this->proxy());
  const double most = this->proxy()->GetProperty("MaximumNumberOfCells")
    ? vtkSMUncheckedPropertyHelper(this->proxy(), "MaximumNumberOfCells").GetAsDouble(0)
    : forecast.Work;
  QString text = "after Apply of the input";
  if (forecast.Work > most)
  {
    text = "about " + Round(forecast.Work) +
      " cells: more than Maximum Number Of Cells allows. Use fewer levels.";
  }
  else if (forecast.Cells > 0.)
  {
    text = (forecast.IsAtMost ? "at most " : "about ") + Round(forecast.Cells) + " cells, " +
      Size(forecast.Bytes);
    if (forecast.Seconds > 0.)
    {
      text += forecast.Seconds < 1. ? QString(", below 1 s")
                                    : ", about " + Round(forecast.Seconds) + " s";
    }
  }
  this->Text->setText(text);
}
