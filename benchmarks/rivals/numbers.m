% SPDX-License-Identifier: BSD-3-Clause
% Raw doubles of a file of the problem, by columns.
function x = numbers(folder, name, rows)
  file = fopen(fullfile(folder, name), "r");
  x = fread(file, [rows, Inf], "double");
  fclose(file);
endfunction
