# Debian 12 with the engine, Python and ROS:
# docker build -t ratchet_sieve . && docker run --rm -it -v "$PWD":/root ratchet_sieve
FROM debian:bookworm AS build
COPY . /ratchet_sieve
RUN /ratchet_sieve/scripts/package /packages

FROM debian:bookworm-slim
COPY --from=build /packages /packages
RUN apt-get update && apt-get install -y --no-install-recommends /packages/*.deb python3-matplotlib python3-scipy && rm -rf /var/lib/apt/lists/*
ENV ROS_HOSTNAME=localhost
WORKDIR /root
CMD ["bash"]
