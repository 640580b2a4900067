// SPDX-License-Identifier: BSD-3-Clause
#include "trivet/elements/law.h"

#ifdef WRONG
using Argument = double;
#else
using Argument = trivet::elements::Matrix12;
#endif

void set_stiffness(trivet::elements::Law& law, const Argument& stiffness) { law.nominal_stiffness = stiffness; }
