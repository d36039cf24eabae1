FROM python:3.13-slim-trixie

# tini -g passes a stop on to every worker; without it they outlive their parent.
RUN apt-get update \
    && apt-get install --yes --no-install-recommends "tini=0.19.*" \
    && rm -rf /var/lib/apt/lists/* \
    && useradd --create-home --uid 1000 lecture
WORKDIR /app
COPY requirements.txt .
RUN pip install --no-cache-dir --require-hashes --requirement requirements.txt
COPY app.py ./
COPY components components
COPY physics physics
COPY static static
USER 1000

# ALLOWED_ORIGIN: host:port of pages that may connect, with commas between them. A page from the host that it asks
# may connect in any case, so this is for a proxy that changes the Host header and for other sites' frames.
ENV PORT=5006 NUM_PROCS=1 PYTHONDONTWRITEBYTECODE=1
EXPOSE 5006
HEALTHCHECK --interval=30s --timeout=5s --start-period=20s CMD ["python", "-c", "import os, urllib.request as u; u.urlopen(f\"http://127.0.0.1:{os.environ['PORT']}/liveness\", timeout=4)"]
ENTRYPOINT ["tini", "-g", "--"]
CMD ["sh", "-c", "BOKEH_ALLOW_WS_ORIGIN=\"${ALLOWED_ORIGIN:-localhost:$PORT,127.0.0.1:$PORT}\" exec panel serve app.py --index app --static-dirs assets=static --liveness --port \"$PORT\" --num-procs \"$NUM_PROCS\""]
