// SPDX-License-Identifier: BSD-3-Clause
// The script of a report (docs/decisions/report-charts.md).
import './before_charts.js';
import './map_point.js';
import './print.js';
import {offerMachine} from './machine_loader.ts';
import {begin} from './page.js';

begin();
offerMachine();
