% SPDX-License-Identifier: BSD-3-Clause
% q(p) = (K - p^2 A + i p B)^-1 H for many p in GNU Octave: the loop of the paper and the best vectorised forms.
1;

function q = loop(A, B, K, H, p)
  q = zeros(6, numel(p));
  for k = 1:numel(p)
    q(:, k) = (K - p(k)^2 * A + 1i * p(k) * B) \ H;
  endfor
endfunction

% LDL' without pivoting, each entry a vector over frequencies.
function q = vectorised_ldlt(A, B, K, H, p)
  x = p.^2;
  L = cell(6, 6);
  y = cell(1, 6);
  for j = 1:6
    for i = j:6
      z = (K(i, j) - A(i, j) * x) + 1i * (B(i, j) * p);
      for k = 1:j-1
        z -= L{i, k} .* D{j, k};
      endfor
      if i == j
        d = 1 ./ z;
        y{j} = H(j);
        for k = 1:j-1
          y{j} = y{j} - L{j, k} .* y{k};
        endfor
        inverse{j} = d;
      else
        D{i, j} = z;
        L{i, j} = z .* d;
      endif
    endfor
  endfor
  q = zeros(6, numel(p));
  for i = 6:-1:1
    s = y{i} .* inverse{i};
    for k = i+1:6
      s -= L{k, i} .* q(k, :);
    endfor
    q(i, :) = s;
  endfor
endfunction

function [R, lambda] = poles(A, B, K, H)
  [V, D] = eig([zeros(6), eye(6); -A \ K, -A \ B]);
  lambda = diag(D);
  R = V(1:6, :) .* (V \ [zeros(6, 1); A \ H]).';
endfunction

function q = vectorised_modal(A, B, K, H, p)
  [R, lambda] = poles(A, B, K, H);
  q = R * (1 ./ (1i * p - lambda));
endfunction

% In pieces that stay in the cache.
function q = in_pieces(evaluate, p, piece)
  q = zeros(6, numel(p));
  for first = 1:piece:numel(p)
    some = first:min(first + piece - 1, numel(p));
    q(:, some) = evaluate(p(some));
  endfor
endfunction

function q = vectorised_modal_in_pieces(A, B, K, H, p)
  [R, lambda] = poles(A, B, K, H);
  q = in_pieces(@(some) R * (1 ./ (1i * some - lambda)), p, 4000);
endfunction

folder = argv(){end};
addpath(fileparts(mfilename("fullpath")));
A = numbers(folder, "A", 6);
B = numbers(folder, "B", 6);
K = numbers(folder, "K", 6);
H = numbers(folder, "H", 6);
p = numbers(folder, "p", 1);
ways.loop = @() loop(A, B, K, H, p);
ways.ldlt = @() in_pieces(@(some) vectorised_ldlt(A, B, K, H, some), p, 2500);
ways.modal = @() vectorised_modal(A, B, K, H, p);
ways.modal_in_pieces = @() vectorised_modal_in_pieces(A, B, K, H, p);
serve(folder, ways);
