n = also_undeclared;
