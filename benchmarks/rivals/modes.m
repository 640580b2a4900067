% SPDX-License-Identifier: BSD-3-Clause
% K v = lambda A v of many designs in GNU Octave.
1;

function lambda = loop(A, K)
  lambda = zeros(6, size(A, 3));
  for d = 1:size(A, 3)
    [V, L] = eig(K(:, :, d), A(:, :, d));
    lambda(:, d) = diag(L);
  endfor
endfunction

function ways = read(folder)
  A = reshape(numbers(folder, "A", 36), 6, 6, []);
  K = reshape(numbers(folder, "K", 36), 6, 6, []);
  ways.loop = @() loop(A, K);
endfunction

addpath(fileparts(mfilename("fullpath")));
serve(argv(){end}, @read);
