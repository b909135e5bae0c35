    for (int t = 0; t < n; t++) // EXPECT: refuse in-header
        h[s[t]]++;
