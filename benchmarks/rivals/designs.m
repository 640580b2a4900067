% SPDX-License-Identifier: BSD-3-Clause
% Largest |q_j| over 500 frequencies of many designs in GNU Octave.
1;

function highest = over_designs(A, B, K, solve)
  highest = zeros(6, size(A, 3));
  for d = 1:size(A, 3)
    highest(:, d) = max(abs(solve(A(:, :, d), B(:, :, d), K(:, :, d))), [], 2);
  endfor
endfunction

function ways = read(folder)
  A = reshape(numbers(folder, "A", 36), 6, 6, []);
  B = reshape(numbers(folder, "B", 36), 6, 6, []);
  K = reshape(numbers(folder, "K", 36), 6, 6, []);
  H = numbers(folder, "H", 6);
  p = numbers(folder, "p", 1);
  ways.loop = @() over_designs(A, B, K, @(A, B, K) loop(A, B, K, H, p));
  ways.ldlt = @() over_designs(A, B, K, @(A, B, K) vectorised_ldlt(A, B, K, H, p));
  ways.modal = @() over_designs(A, B, K, @(A, B, K) vectorised_modal(A, B, K, H, p));
endfunction

addpath(fileparts(mfilename("fullpath")));
serve(argv(){end}, @read);
