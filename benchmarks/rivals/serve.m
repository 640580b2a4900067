% SPDX-License-Identifier: BSD-3-Clause
% Answers requests line by line: names of the ways that `read` gives for the problem in the folder (a struct of functions), answers
% written to a file, CPU seconds of one call.
function serve(folder, read)
  sigterm_dumps_octave_core(false);
  sighup_dumps_octave_core(false);
  while ischar(request = fgetl(stdin))
    [what, name] = strtok(request);
    name = strtrim(name);
    switch what
      case "names"
        ways = read(folder);
        printf("%s\n", strjoin(fieldnames(ways), " "));
      case "answer"
        x = ways.(name)();
        file = fopen(fullfile(folder, [name ".answer"]), "w");
        fwrite(file, [real(x(:)).'; imag(x(:)).'], "double");
        fclose(file);
        printf("done\n");
      case "time"
        from = cputime();
        ways.(name)();  % fills the caches that the others emptied
        spent = cputime() - from;
        calls = 1;
        if spent < 20e-3
          calls = 0;
          from = cputime();
          do
            ways.(name)();
            calls++;
            spent = cputime() - from;
          until spent >= 1e-3
        endif
        printf("%.12g\n", spent / calls);
    endswitch
    fflush(stdout);
  endwhile
endfunction
